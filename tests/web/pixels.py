"""Counts the colours of a picture, in the browser that drew it."""

import base64

COUNT = """async ([png, regions]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), drawing = canvas.getContext("2d");
    drawing.drawImage(bitmap, 0, 0);
    const rgb = (text) => {
        drawing.fillStyle = text;
        return [1, 3, 5].map((i) => parseInt(drawing.fillStyle.slice(i, i + 2), 16));
    };
    const found = {};
    for (const [name, { box, colours }] of Object.entries(regions)) {
        const pixels = drawing.getImageData(Math.round(box.x), Math.round(box.y), Math.round(box.width), Math.round(box.height)).data;
        for (const [key, text] of Object.entries(colours)) {
            const colour = rgb(text);
            let count = 0;
            for (let i = 0; i < pixels.length; i += 4) count += colour.every((one, k) => Math.abs(one - pixels[i + k]) <= 16);
            found[`${name}: ${key}`] = count;
        }
    }
    return { size: [bitmap.width, bitmap.height], found };
}"""

COLOUR = """async ([png, places]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))]));
    const drawing = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    drawing.drawImage(bitmap, 0, 0);
    return places.map(([x, y]) => [...drawing.getImageData(Math.round(x), Math.round(y), 1, 1).data].slice(0, 3));
}"""


def counted(page, png, regions):
    """(size, {"region: colour": pixels}) of a picture. regions: {name: {"box": .., "colours": {name: CSS colour}}}"""
    answer = page.evaluate(COUNT, [base64.b64encode(png).decode(), regions])
    return answer["size"], answer["found"]


def colours_at(page, png, places):
    """The colour [r, g, b] at each place (x, y)."""
    return page.evaluate(COLOUR, [base64.b64encode(png).decode(), places])
