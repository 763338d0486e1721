import assert from 'node:assert/strict';
import { test } from 'node:test';
import { exceeds, findingsOf, headline, leftOut, programAround } from '../src/view/findings/findings.js';
import { sampleReport } from './sample.js';

const limits = { gouge_mm: 0.01, uncut_mm: 0.02 };
const stage = (parts) => ({ limits, gouges: [], uncuts: [], process: [], ...parts });
const ids = (parts) => findingsOf(stage(parts)).map(({ id }) => id);

test('the worst comes first: beyond a limit, then collisions, then within, then near misses', () => {
  assert.deepEqual(ids({
    gouges: [{ id: 'G1', depth_mm: 0.02 }, { id: 'G2', depth_mm: 0.005 }],
    uncuts: [{ id: 'U1', depth_mm: 0.06 }],
    process: [{ id: 'P1', kind: 'near_miss', fails: false, depth_mm: 0.1 },
      { id: 'P2', kind: 'holder_collision', fails: true, depth_mm: 0.001 }],
  }), ['U1', 'G1', 'P2', 'G2', 'P1']);
});

test('without a limit the deeper comes first', () => {
  const gouges = [{ id: 'G1', depth_mm: 0.1 }, { id: 'G2', depth_mm: 0.3 }];
  const findings = findingsOf({ limits: {}, gouges });
  assert.deepEqual(findings.map(({ id }) => id), ['G2', 'G1']);
  assert.equal(exceeds(findings[0]), false);
});

test('what exceeds a limit and what it is called', () => {
  const [worst] = findingsOf(sampleReport().stages[1]);
  assert.equal(worst.id, 'G1');
  assert.equal(headline(worst), '50.0 µm too deep');
  assert.equal(exceeds(worst), true);
  assert.equal(exceeds({ ...worst, depth_mm: 0.01 }), false, 'the limit itself still passes');
});

test('the program around a finding is that of the stage that cut there', () => {
  const report = sampleReport();
  report.stages[0].text = [{ line: 11, text: 'of the rough stage' }];
  const [worst] = findingsOf(report.stages[1]);
  assert.deepEqual(programAround(report, 1, worst).map(({ text }) => text), ['of the rough stage']);
  assert.deepEqual(programAround(report, 1, { ...worst, raw_stock: true }), []);
});

test('findings that the page leaves out are counted', () => {
  assert.equal(leftOut(stage({ gouges: [{ id: 'G1' }], gouges_total: 700 })), 699);
  assert.equal(leftOut(stage({})), 0);
});
