import { make } from '../../base/dom.js';
import { headline } from './findings.js';

const LABEL = { width: 34, height: 24 };
/** Room that the chosen finding's words may take on the right. */
const LABEL_SPACE = 210;

/**
 * Names of findings over the picture. They are buttons for the mouse; with the keyboard the list beside
 * the picture does the same, so they take no stop of their own.
 */
export function createMarkers(scene, choose, isHidden) {
  const layer = make('div', { class: 'view-markers' });
  scene.element.append(layer);
  let marks = [], chosen = null;
  scene.onFrame(({ moving }) => place(moving));

  const place = (moving) => {
    const taken = [];
    const { width, height } = scene.size();
    // The chosen one has its place before all others.
    const ordered = [...marks].sort((a, b) => (b.finding === chosen) - (a.finding === chosen));
    for (const { finding, element } of ordered) {
      const at = scene.project(finding.point_mm);
      const inside = at.visible && at.x > 0 && at.y > 0 && at.x < width && at.y < height;
      element.hidden = !inside;
      if (!inside) continue;
      element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
      const quiet = finding !== chosen && overlaps(taken, at);
      element.classList.toggle('quiet', quiet);
      element.classList.toggle('leftwards', at.x > width - LABEL_SPACE);
      if (!quiet) taken.push(at);
      if (!moving) element.classList.toggle('behind', isHidden(finding));
    }
  };
  return {
    show(findings) {
      // The worst last, so that they lie on top; places are given out from the worst on.
      marks = findings.filter(({ point_mm }) => point_mm)
        .map((finding) => ({ finding, element: marker(finding, choose) }));
      layer.replaceChildren(...marks.map(({ element }) => element).reverse());
      chosen = null;
      scene.render();
    },
    choose(finding) {
      chosen = marks.find((mark) => mark.finding.id === finding?.id)?.finding ?? null;
      for (const mark of marks) mark.element.classList.toggle('chosen', mark.finding === chosen);
      scene.render();
    },
  };
}

const overlaps = (taken, at) =>
  taken.some((other) => Math.abs(other.x - at.x) < LABEL.width && Math.abs(other.y - at.y) < LABEL.height);

function marker(finding, choose) {
  return make('button', {
    type: 'button', tabindex: '-1', class: `view-marker ${finding.kind}`, title: headline(finding),
    'aria-label': `${finding.id}: ${headline(finding)}`,
    data: { markerId: finding.id }, on: { click: () => choose(finding.id) },
  }, [
    make('i'),
    make('span', { class: 'view-tag' }, [
      make('b', { text: finding.id }), make('em', { text: headline(finding) }),
    ]),
  ]);
}
