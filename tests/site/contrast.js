// Whether every text of the page stands out from what lies behind it: 4.5 : 1, and 3 : 1 where it is large (WCAG 2.1, 1.4.3). Else the
// first texts that do not. Words in drawings of a figure take their colours from the page.
const numbers = (color) => { const [r, g, b, a = 1] = color.match(/[0-9.]+/g).map(Number); return [r, g, b, a]; };
const over = (top, below) => [0, 1, 2].map((c) => top[3] * top[c] + (1 - top[3]) * below[c]);
const luminance = (color) => color.slice(0, 3).map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
  .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) => { const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y); return (high + 0.05) / (low + 0.05); };
const behind = (node) => (node ? over(numbers(getComputedStyle(node).backgroundColor), behind(node.parentElement)) : [255, 255, 255]);
const wrong = [];
const check = (words, color, back, least) => {
  const found = contrast(over(numbers(color), back), back);
  if (found < least) wrong.push(`${words.trim().slice(0, 30)}: ${found.toFixed(2)}`);
};
let count = 0;
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const node = walker.currentNode, of = node.parentElement;
  if (!node.data.trim() || !of.checkVisibility() || of.closest('script, style, noscript, svg')) continue;
  const { color, fontSize, fontWeight } = getComputedStyle(of), size = parseFloat(fontSize);
  ++count;
  check(node.data, color, behind(of), size >= 24 || (size >= 18.66 && fontWeight >= 700) ? 3 : 4.5);
}
const probe = document.body.appendChild(document.createElement('i'));
for (const figure of document.querySelectorAll('figure.live')) {
  for (const name of ['ink', 'muted', 'good']) {
    probe.style.color = `var(--${name})`;
    check(`${name} in a figure`, getComputedStyle(probe).color, behind(figure), 4.5);
  }
}
probe.remove();
return count > 0 && wrong.length === 0 ? true : `${count} texts; ${wrong.slice(0, 5).join('; ')}`;
