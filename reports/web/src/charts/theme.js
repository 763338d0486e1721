/** The page's colours as they are now: light or dark. */
export function pageColours(root = document.documentElement) {
  const style = getComputedStyle(root);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    ink: colour('ink'), soft: colour('soft'), rule: colour('rule'), panel: colour('panel'),
    bar: colour('bar'), gouge: colour('gouge'), uncut: colour('uncut'),
    fail: colour('fail'), open: colour('open'), link: colour('link'), font: colour('sans'),
    pass: colour('pass'), none: colour('none'), page: colour('page'),
  };
}

/** What every chart has in common. */
export function commonOption(colours, description) {
  return {
    animation: false,
    textStyle: { fontFamily: colours.font, color: colours.ink },
    aria: { enabled: true, label: { description } },
    tooltip: {
      trigger: 'axis', confine: true, transitionDuration: 0, position: besidePointer,
      backgroundColor: colours.panel, borderColor: colours.rule,
      textStyle: { color: colours.ink, fontFamily: colours.font, fontSize: 14 },
    },
  };
}

/** At the chart's upper edge, on the side with more room: what is pointed at stays in sight. */
function besidePointer([x], params, element, place, { contentSize, viewSize }) {
  return [x < viewSize[0] / 2 ? x + 16 : x - contentSize[0] - 16, 0];
}

/** An axis in the page's colours. */
export function axisOption(colours, more) {
  return {
    axisLine: { show: true, onZero: false, lineStyle: { color: colours.ink } },
    axisTick: { lineStyle: { color: colours.ink } },
    axisLabel: { color: colours.soft, fontSize: 13, hideOverlap: true },
    nameTextStyle: { color: colours.soft, fontSize: 13 },
    splitLine: { lineStyle: { color: colours.rule } },
    ...more,
  };
}

/** Lines of a tooltip as elements: what stands in them stays text. */
export function tooltipLines(lines) {
  const box = document.createElement('div');
  for (const text of lines) {
    const line = document.createElement('div');
    line.textContent = text;
    box.append(line);
  }
  return box;
}
