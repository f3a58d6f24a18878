// Saving what is seen as a picture: the canvas, and over it the words and signs of the figure, at twice the size of the page.

import { cssColor } from "./color_map";

const SCALE = 2;

/** @param draw draws the canvas at a scale */
export function figurePicture(figure: HTMLElement, canvas: HTMLCanvasElement, draw: (scale: number) => void): HTMLCanvasElement {
  const around = figure.getBoundingClientRect();
  const picture = document.createElement("canvas");
  picture.width = Math.round(around.width * SCALE);
  picture.height = Math.round(around.height * SCALE);
  const context = picture.getContext("2d")!;
  context.scale(SCALE, SCALE);
  context.translate(-around.left, -around.top);
  context.fillStyle = getComputedStyle(figure).backgroundColor;
  context.fillRect(around.left, around.top, around.width, around.height);
  draw(SCALE);
  const box = canvas.getBoundingClientRect();
  context.drawImage(canvas, box.left, box.top, box.width, box.height);
  paint(figure, context);
  return picture;
}

/** What of the page lies on the canvas: backgrounds of signs, and text. */
function paint(element: HTMLElement, context: CanvasRenderingContext2D): void {
  for (const child of element.childNodes) {
    if (child instanceof HTMLElement && !(child instanceof HTMLCanvasElement)) {
      paintBox(child, context);
      paint(child, context);
    } else if (child instanceof Text && child.data.trim()) paintText(child, element, context);
  }
}

function paintBox(element: HTMLElement, context: CanvasRenderingContext2D): void {
  const { left, top, width, height } = element.getBoundingClientRect();
  const style = getComputedStyle(element);
  if (element.className === "replay-bar-colors") {
    const gradient = context.createLinearGradient(left, 0, left + width, 0);
    for (let k = 0; k <= 16; k++) gradient.addColorStop(k / 16, cssColor(k / 16));
    context.fillStyle = gradient;
  } else context.fillStyle = style.backgroundColor;
  context.beginPath();
  context.roundRect(left, top, width, height, Math.min(parseFloat(style.borderTopLeftRadius) || 0, width / 2));
  context.fill();
}

function paintText(text: Text, parent: HTMLElement, context: CanvasRenderingContext2D): void {
  const style = getComputedStyle(parent);
  const range = document.createRange();
  range.selectNodeContents(text);
  const { left, top, height } = range.getBoundingClientRect();
  context.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  context.fillStyle = style.color;
  context.textBaseline = "middle";
  context.fillText(text.data.trim(), left, top + height / 2);
}

export async function download(picture: HTMLCanvasElement, name: string): Promise<void> {
  const blob = await new Promise<Blob | null>((done) => picture.toBlob(done, "image/png"));
  if (!blob) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
