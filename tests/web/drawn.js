// What is drawn in a view of the browser demo: arrows, stick areas, lines. Run in the page by page.py.
(view) => {
    const panel = document.getElementById(`view-${view}`);
    const all = (selector) => [...panel.querySelectorAll(`.pictures ${selector}`)].filter((one) => !one.closest(".key"));
    const pairs = (path) => path.getAttribute("d").split("M").slice(1).map((part) => part.split(/[ L]/).map(Number));
    // Each arrow is a shaft and a head
    const arrowsOf = (path) => {
        const shafts = pairs(path).filter((_, i) => i % 2 === 0);
        return { count: shafts.length, x: shafts.reduce((sum, s) => sum + s[2] - s[0], 0), y: shafts.reduce((sum, s) => sum + s[3] - s[1], 0) };
    };
    // The part of an outline that a shape covers
    const cover = (outline, shape) => {
        const box = outline.getBBox(), n = 80;
        let inside = 0, covered = 0;
        for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) {
            const point = new DOMPoint(box.x + ((i + 0.5) / n) * box.width, box.y + ((j + 0.5) / n) * box.height);
            if (!outline.isPointInFill(point)) continue;
            inside += 1;
            covered += shape.isPointInFill(point);
        }
        return covered / inside;
    };
    const outlines = all(".rim, .outline"), sticks = all(".stick"), slips = all(".slip");
    return {
        arrows: all(".arrows:not(.faulty)").map(arrowsOf),
        faulty: all(".arrows.faulty").map((path) => arrowsOf(path).count).reduce((sum, one) => sum + one, 0),
        stick: outlines.map((outline, i) => cover(outline, sticks[i])),
        slip: outlines.map((outline, i) => (slips[i] ? cover(outline, slips[i]) : null)),
        curves: all(".curve").map((path) => path.getAttribute("d").split(/[ML]/).length - 1),
        rings: all("circle.fastsim").length,
        profiles: all(".profile").map((path) => path.getAttribute("d").split(/[ML]/).length - 1),
        shades: all(".pressure").filter((path) => path.getAttribute("d")).length,
    };
}
