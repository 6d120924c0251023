// Typesets the equations that pymdownx.arithmatex has marked: \(…\) in a line, \[…\] on a line of their own.
for (const place of document.querySelectorAll(".arithmatex")) {
  const source = place.textContent.trim();
  katex.render(source.slice(2, -2), place, { displayMode: source.startsWith("\\["), throwOnError: false });
}
