/** Elements that a reader can operate, as far as they are shown. */
export const controls = 'button, input, select, a[href], summary, [tabindex="0"]';

/**
 * What does not fit a screen of the page's width: elements beyond its sides that no box of their own
 * scrolls or hides, and controls that are cut off by one.
 */
export function misfits(page) {
  return page.evaluate((controls) => {
    const width = document.documentElement.clientWidth, faults = [];
    const describe = (e) => `${e.tagName.toLowerCase()}.${e.className?.baseVal ?? e.className} ` +
      `"${(e.textContent ?? '').trim().slice(0, 40)}"`;
    /** Whether a box between the element and the page takes what sticks out; "hidden" swallows it. */
    const keeper = (element) => {
      for (let e = element.parentElement; e && e !== document.body; e = e.parentElement) {
        const { overflowX } = getComputedStyle(e);
        if (overflowX !== 'visible') return { box: e.getBoundingClientRect(), overflowX };
      }
      return undefined;
    };
    if (document.documentElement.scrollWidth > width)
      faults.push(`the page scrolls sideways: ${document.documentElement.scrollWidth} px`);
    for (const element of document.querySelectorAll('body *')) {
      const box = element.getBoundingClientRect();
      if (box.width <= 1 || box.height <= 1 || !element.checkVisibility({ visibilityProperty: true }))
        continue;
      const out = box.left < -1 || box.right > width + 1;
      const kept = keeper(element);
      if (out && !kept) faults.push(`beyond the screen: ${describe(element)}`);
      if (!element.matches(controls)) continue;
      const cut = kept?.overflowX === 'hidden' &&
        (box.left < kept.box.left - 1 || box.right > kept.box.right + 1);
      if (cut || (out && kept?.overflowX !== 'auto')) faults.push(`cut off: ${describe(element)}`);
    }
    return [...new Set(faults)];
  }, controls);
}

/**
 * Controls smaller than WCAG 2.2 asks of a target (24 px each way, or as much room to its neighbours);
 * links inside a line of text are exempt there, and native boxes count with their label.
 */
export function smallTargets(page) {
  return page.evaluate((controls) => {
    const least = 24, faults = [];
    const boxes = [...document.querySelectorAll(controls)]
      .filter((e) => e.checkVisibility({ visibilityProperty: true }) && !e.closest('p, li, td, dd, caption'))
      .map((e) => ({ e, box: (e.closest('label') ?? e).getBoundingClientRect() }))
      .filter(({ box }) => box.width > 1 && box.height > 1);
    for (const { e, box } of boxes)
      if (box.width < least || box.height < least)
        faults.push(`${e.tagName} "${(e.ariaLabel ?? e.textContent ?? '').trim().slice(0, 40)}" ` +
          `${box.width.toFixed(0)} x ${box.height.toFixed(0)} px`);
    return faults;
  }, controls);
}

/** Words of scales that run into each other: pairs of their texts. */
export function meetingLabels(page) {
  return page.evaluate(() => {
    const faults = [];
    const scales = '.view-ticks, .view-words, .path-legend-ticks, .below, .above';
    const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 &&
      a.top < b.bottom - 1 && b.top < a.bottom - 1;
    for (const scale of document.querySelectorAll(scales)) {
      if (!scale.checkVisibility()) continue;
      const labels = [...scale.children]
        .map((e) => ({ text: e.textContent, box: e.getBoundingClientRect() }))
        .filter(({ box }) => box.width > 0);
      labels.forEach((a, i) => labels.slice(i + 1).forEach((b) => {
        if (meet(a.box, b.box)) faults.push(`${a.text} | ${b.text}`);
      }));
    }
    return faults;
  });
}
