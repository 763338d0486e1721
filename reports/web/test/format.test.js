import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as format from '../src/base/format.js';

test('three significant digits, micrometres below a tenth of a millimetre', () => {
  assert.equal(format.measuredLength(0.000445), '0.445 µm');
  assert.equal(format.measuredLength(0.0498123), '49.8 µm');
  assert.equal(format.measuredLength(0.1), '0.100 mm');
  assert.equal(format.measuredLength(1.2499), '1.25 mm');
  assert.equal(format.measuredLength(-0.0099996), '−10.0 µm');
  assert.equal(format.threeDigits(999.7), '1000');
  assert.equal(format.threeDigits(0), '0');
  assert.equal(format.threeDigits(0.00001234), '1.23e−5');
});

test('stated lengths keep their digits', () => {
  assert.equal(format.statedLength(0.01), '10 µm');
  assert.equal(format.statedLength(0.2), '0.2 mm');
  assert.equal(format.statedLength(0), '0 mm');
  assert.equal(format.signedLength(0.05), '+50 µm');
  assert.equal(format.signedLength(-0.05), '−50 µm');
});

test('deviations carry their sign; below a nanometre there is none', () => {
  assert.equal(format.signedMeasured(0.0498123), '+49.8 µm');
  assert.equal(format.signedMeasured(-0.0498123), '−49.8 µm');
  assert.equal(format.signedMeasured(-5e-13), '0 µm');
});

test('never minus zero', () => {
  assert.equal(format.fixed(-0.0001, 2), '0.00');
  assert.equal(format.coordinate(-1.23456), '−1.235');
});

test('words for a deviation follow the limits, which themselves still pass', () => {
  const limits = { gouge_mm: 0.01, uncut_mm: 0.02 };
  assert.equal(format.deviationWord(-0.01, limits), 'in tolerance');
  assert.equal(format.deviationWord(-0.011, limits), 'cut too deep');
  assert.equal(format.deviationWord(0.021, limits), 'material left');
  assert.equal(format.deviationWord(0.001, {}), 'material left');
});
