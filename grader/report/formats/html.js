{
  // The colours of a difference: those of report/pictures.cpp, by the logarithm of the largest channel's.
  const stops = [[0, .1, .35], [.25, .3, .45], [.5, .49, .47], [.75, .68, .38], [1, .9, .2]];
  const colours = Array.from({ length: 256 }, (_, difference) => {
    if (difference === 0) return [0, 0, 0];
    const position = Math.log2(difference) / 8 * (stops.length - 1);
    const i = Math.min(Math.floor(position), stops.length - 2);
    return stops[i].map((low, c) => Math.round(255 * (low + (position - i) * (stops[i + 1][c] - low))));
  });

  const drawing = (width, height) => {
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    return [canvas, canvas.getContext("2d", { willReadFrequently: true })];
  };

  const pixels_of = (image, width, height) => {
    const [canvas, context] = drawing(width, height);
    context.drawImage(image, 0, 0);
    return [canvas, context.getImageData(0, 0, width, height).data];
  };

  const largest = (a, b, i) => Math.max(Math.abs(a[i] - b[i]), Math.abs(a[i + 1] - b[i + 1]), Math.abs(a[i + 2] - b[i + 2]));

  const draw_difference = (a, b, width, height) => {
    const [canvas, context] = drawing(width, height);
    const picture = context.createImageData(width, height);
    for (let i = 0; i < picture.data.length; i += 4)
      picture.data.set([...colours[largest(a, b, i)], 255], i);
    context.putImageData(picture, 0, 0);
    return canvas;
  };

  const show_slider = (compare, mine, theirs) => {
    compare.querySelector(".under").src = theirs.src;
    const over = compare.querySelector(".over");
    over.src = mine.src;
    const slider = compare.querySelector("input");
    const wipe = () => { over.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`; };
    slider.addEventListener("input", wipe);
    wipe();
  };

  // What is around a pixel, eight times as large, with the pixel framed.
  const zoom = (target, source, x, y) => {
    const context = target.getContext("2d");
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, 136, 136);
    context.drawImage(source, x - 8, y - 8, 17, 17, 0, 0, 136, 136);
    context.strokeStyle = "#fff";
    context.strokeRect(63.5, 63.5, 9, 9);
    context.strokeStyle = "#000";
    context.strokeRect(62.5, 62.5, 11, 11);
  };

  const prepare = async card => {
    const [mine, theirs] = [...card.querySelectorAll(".mine img, .theirs img")];
    await Promise.all([mine.decode(), theirs.decode()]);
    const width = theirs.naturalWidth, height = theirs.naturalHeight;
    if (mine.naturalWidth !== width || mine.naturalHeight !== height) return;
    const [canvas_a, a] = pixels_of(mine, width, height);
    const [canvas_b, b] = pixels_of(theirs, width, height);
    const map = draw_difference(a, b, width, height);
    const figure = card.querySelector(".difference");
    if (figure) {
      const shown = figure.querySelector("img");
      map.setAttribute("role", "img");
      map.setAttribute("aria-label", shown.alt);
      shown.replaceWith(map);
    }
    const words = document.getElementById("compare-words").content.cloneNode(true);
    const compare = words.querySelector(".compare"), loupe = words.querySelector(".loupe");
    show_slider(compare, mine, theirs);
    card.querySelector(".shots").append(compare);
    card.append(loupe);

    const [x_field, y_field] = loupe.querySelectorAll("input");
    const [zoom_a, zoom_b, zoom_d] = loupe.querySelectorAll("canvas");
    x_field.max = width - 1;
    y_field.max = height - 1;
    const look = () => {
      const x = Math.min(Math.max(x_field.value | 0, 0), width - 1), y = Math.min(Math.max(y_field.value | 0, 0), height - 1);
      zoom(zoom_a, canvas_a, x, y);
      zoom(zoom_b, canvas_b, x, y);
      zoom(zoom_d, map, x, y);
      const i = 4 * (y * width + x);
      loupe.querySelector(".a").value = `${a[i]} ${a[i + 1]} ${a[i + 2]}`;
      loupe.querySelector(".b").value = `${b[i]} ${b[i + 1]} ${b[i + 2]}`;
      loupe.querySelector(".d").value = largest(a, b, i);
    };
    const follow = event => {
      const at = event.currentTarget.getBoundingClientRect();
      x_field.value = Math.floor((event.clientX - at.left) / at.width * width);
      y_field.value = Math.floor((event.clientY - at.top) / at.height * height);
      look();
    };
    for (const surface of card.querySelectorAll(".mine img, .theirs img, .difference canvas, .stage"))
      for (const kind of ["pointermove", "pointerdown"]) surface.addEventListener(kind, follow);
    for (const field of [x_field, y_field]) field.addEventListener("input", look);
    // It begins where the pictures differ most.
    let worst = 0, most = -1;
    for (let i = 0; i < a.length; i += 4)
      if (largest(a, b, i) > most) [worst, most] = [i / 4, largest(a, b, i)];
    x_field.value = worst % width;
    y_field.value = Math.floor(worst / width);
    look();
  };

  const seen = new IntersectionObserver(entries => {
    for (const entry of entries)
      if (entry.isIntersecting) {
        seen.unobserve(entry.target);
        prepare(entry.target).catch(() => {});  // what cannot be decoded stays as it is
      }
  }, { rootMargin: "600px" });
  for (const card of document.querySelectorAll(".picture.in-full")) seen.observe(card);

  // A link to a function opens what hides it.
  const open_target = () => {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target instanceof HTMLDetailsElement) target.open = true;
  };
  addEventListener("hashchange", open_target);
  open_target();
}
