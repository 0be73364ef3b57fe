addEventListener("load", async () => {
  const wrong = [];
  const expect = (what, holds) => { if (!holds) wrong.push(what); };
  try {
    for (const group of document.querySelectorAll(".group")) {
      const figure = group.closest("figure"), id = figure.id;
      const pictures = [...group.querySelectorAll(".picture[data-file]")];
      if (pictures.length === 0) continue;
      const key = (name) => group.querySelector(".stage").dispatchEvent(new KeyboardEvent("keydown", { key: name }));
      key("+");
      expect(id + ": zooms", getComputedStyle(group).getPropertyValue("--zoom").trim() === "2");
      key("ArrowRight");
      await Promise.all(pictures.map((picture) => pixels_of(picture.dataset.file)));
      await new Promise((done) => setTimeout(done, 50));
      const lines = figure.querySelector(".readout").textContent.split("\n");
      expect(id + ": reads " + lines.length, lines.length === pictures.length + 1);
      expect(id + ": finite", !/NaN|undefined/.test(lines.join()));
      if (pictures.some((picture) => picture.dataset.kind === "film")) {
        key("]");
        await new Promise((done) => setTimeout(done, 100));
        expect(id + ": exposes", group.querySelector("canvas") !== null);
      }
      const slider = [...figure.querySelectorAll(".tools button")].find((each) => each.textContent === "slider");
      if (slider) {
        slider.click();
        expect(id + ": slider", figure.querySelectorAll(".compare .layer:not([hidden])").length === 2);
        key("f");
        key("f");
        expect(id + ": flips", figure.querySelectorAll(".compare .layer:not([hidden])").length === 1);
        const step = figure.querySelector(".compare input[aria-valuetext]");
        step.value = pictures.length - 1;
        step.dispatchEvent(new Event("input"));
        expect(id + ": steps to the last picture", ![...figure.querySelectorAll(".compare .layer")].at(-1).hidden);
        const dots = [...figure.querySelectorAll(".curve circle")];
        expect(id + ": marks its error", dots.length === 0 || dots.at(-1).classList.contains("here"));
      }
      key("0");
      expect(id + ": takes it back", !group.hidden && getComputedStyle(group).getPropertyValue("--zoom").trim() === "1");
    }
    expect("pictures are shown", [...document.images].every((image) => !image.complete || image.naturalWidth > 0));
  } catch (error) {
    wrong.push(String(error));
  }
  document.documentElement.dataset.tried = wrong.length ? wrong.join("; ") : "good";
});
