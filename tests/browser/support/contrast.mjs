/**
 * Words whose colour stands out from their ground by less than WCAG's 4.5 : 1 (3 : 1 from 24 px, or 18.7 px
 * bold). Words over pictures are left out: their ground is no one colour.
 */
export function faintWords(page) {
  return page.evaluate(() => {
    const canvas = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
    const rgba = (css) => {
      canvas.clearRect(0, 0, 1, 1);
      canvas.fillStyle = css;
      canvas.fillRect(0, 0, 1, 1);
      const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
      return [r, g, b, a / 255];
    };
    const over = (top, ground) => ground.map((c, i) => top[i] * top[3] + c * (1 - top[3]));
    const ground = (element) => {
      const layers = [];
      for (let e = element; e; e = e.parentElement) {
        const style = getComputedStyle(e);
        if (style.backgroundImage !== 'none') return undefined;
        layers.push(rgba(style.backgroundColor));
        if (layers.at(-1)[3] === 1) break;
      }
      return layers.reduceRight((below, layer) => over(layer, below), [255, 255, 255]);
    };
    const light = (rgb) => {
      const [r, g, b] = rgb.map((c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const faults = new Set();
    const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node; (node = words.nextNode());) {
      const element = node.parentElement;
      if (!node.data.trim() || element.closest('script, style, noscript, svg, .frame, option, :disabled') ||
        !element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      const below = ground(element);
      if (!below) continue;
      const style = getComputedStyle(element);
      const ink = over(rgba(style.color), below);
      const [dark, bright] = [light(ink), light(below)].sort((a, b) => a - b);
      const ratio = (bright + 0.05) / (dark + 0.05), size = parseFloat(style.fontSize);
      const least = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
      if (ratio < least) faults.add(`${ratio.toFixed(2)} : 1, "${node.data.trim().slice(0, 40)}"`);
    }
    return [...faults];
  });
}
