
// The size of the picture on the page, and its pixels, enlarged.

const kZooms = [1, 2, 4, 8, 16, 32, 64];
const kRoomForNumbers = 40;  // px of a pixel

// How many times it is enlarged, and the corner of what is seen: parts of the picture from its upper left corner.
const zoomed = { times: 1, x: 0, y: 0 };

// The width of lines and letters, in units of the canvas.
const pen = () => devicePixelRatio / zoomed.times;

// A whole number of points of the screen for each pixel, where there is room for two or more; else the picture is smoothed.
function fit_stage() {
  const { width, height } = by_id("picture");
  const room = Math.min(stage.parentElement.clientWidth, (0.56 * innerHeight * width) / height);
  const points = Math.floor((room * devicePixelRatio) / width);
  const wide = points < 2 ? room : (points * width) / devicePixelRatio;
  stage.style.width = `${wide}px`;
  by_id("beside").style.width = `${wide}px`;
  show_zoomed();
}

function show_zoomed() {
  const { times, x, y } = zoomed;
  const canvas = by_id("picture");
  const points = (stage.clientWidth * devicePixelRatio * times) / canvas.width;
  canvas.style.transform = `scale(${times}) translate(${-100 * x}%, ${-100 * y}%)`;
  canvas.style.imageRendering = points < 2 ? "auto" : "pixelated";
}

const inside = (corner) => Math.min(Math.max(corner, 0), 1 - 1 / zoomed.times);

// Moves what is seen by parts of the stage.
function pan(right, down) {
  zoomed.x = inside(zoomed.x + right / zoomed.times);
  zoomed.y = inside(zoomed.y + down / zoomed.times);
  show_zoomed();
  show_lines();
}

// Enlarges, so that the place of the picture at `at` stays where it is.
function zoom_to(times, at) {
  const before = zoomed.times;
  zoomed.times = times;
  zoomed.x = inside(at[0] - ((at[0] - zoomed.x) * before) / times);
  zoomed.y = inside(at[1] - ((at[1] - zoomed.y) * before) / times);
  controls.zoom.value = times;
  show_zoomed();
  show_lines();
}

// The middle of the pixel below the pointer, of the marked one, or of what is seen.
function place_to_zoom() {
  const pixel = now.pointer ?? (is_pixel_here() ? now.pixel : null);
  if (!pixel) return [zoomed.x + 0.5 / zoomed.times, zoomed.y + 0.5 / zoomed.times];
  return [(pixel[0] + 0.5) / data.settings.w, 1 - (pixel[1] + 0.5) / data.settings.h];
}

function zoom_by(step, at = place_to_zoom()) {
  const i = Math.min(Math.max(kZooms.indexOf(zoomed.times) + step, 0), kZooms.length - 1);
  zoom_to(kZooms[i], at);
}

// A pixel that was chosen by keys is brought into what is seen.
function keep_in_sight([x, y]) {
  const [left, top] = [x / data.settings.w, 1 - (y + 1) / data.settings.h];
  const side = (corner, low, size) => (low < corner ? low : low + size > corner + 1 / zoomed.times ? low + size - 1 / zoomed.times : corner);
  zoomed.x = inside(side(zoomed.x, left, 1 / data.settings.w));
  zoomed.y = inside(side(zoomed.y, top, 1 / data.settings.h));
  show_zoomed();
}

// The numbers of the pixels that are seen, where there is room for them.
function draw_numbers(context, picture) {
  const { times, x, y } = zoomed;
  const side = (stage.clientWidth * times) / picture.width;
  if (side < kRoomForNumbers || now.camera !== picture.camera) return;
  const [w, h] = [context.canvas.width / picture.width, context.canvas.height / picture.height];
  const size = Math.min(side / 4.4, 13) * pen();
  context.font = `${size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.lineWidth = 2.5 * pen();
  context.strokeStyle = "rgb(0 0 0 / 0.8)";
  context.setLineDash([]);
  const last = (corner, count) => Math.min(Math.ceil((corner + 1 / times) * count), count);
  for (let j = Math.floor(y * picture.height); j < last(y, picture.height); ++j) {
    for (let i = Math.floor(x * picture.width); i < last(x, picture.width); ++i) {
      const at = 3 * (j * picture.width + i);
      const values = picture.floats.subarray(at, at + (now.kind === "light" ? 3 : 1));
      values.forEach((value, c) => {
        context.fillStyle = values.length === 1 ? "#fff" : ["#ff9c8f", "#8fe6a3", "#9ccaff"][c];
        const place = [(i + 0.5) * w, (j + 0.5) * h + (c - values.length / 2 + 0.8) * 1.15 * size];
        context.strokeText(brief(value), ...place);
        context.fillText(brief(value), ...place);
      });
    }
  }
  context.textAlign = "start";
}

const brief = (value) => (value === 0 ? "0" : value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : Number.isFinite(value) ? value.toFixed(3) : "none");
