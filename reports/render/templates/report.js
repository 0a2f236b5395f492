// Draws the curves of the selected outlet. All data are in #plot-data; nothing is fetched.
(function () {
  "use strict";
  const element = (id) => document.getElementById(id);
  if (!element("frequency-plot")) return;

  const data = JSON.parse(element("plot-data").textContent);
  const root = document.documentElement;
  const choice = element("outlet-choice");
  const AXIS_WIDTH = 68;

  // Colour (a variable of report.css), unit and digits of each series.
  const FREQUENCY = [
    { label: "measured frequency", colour: "measured", unit: "Hz", digits: 4 },
    { label: "reference frequency", colour: "true", unit: "Hz", digits: 4 },
    { label: "ΔP estimate", colour: "estimate", unit: "MW", digits: 1 },
    { label: "ΔP flagged as unreliable", colour: "doubt", unit: "MW", digits: 1, dotted: true },
  ];
  const ROCOF = [
    { label: "measured ROCOF", colour: "measured", unit: "Hz/s", digits: 3 },
    { label: "reference ROCOF", colour: "true", unit: "Hz/s", digits: 3 },
  ];

  const colour = (name) => getComputedStyle(root).getPropertyValue("--" + name).trim();
  const axisNumber = (value, digits) => String(+value.toFixed(digits)).replace("-", "\u2212");

  // Dygraphs needs one table: null if a series has no entry at that time (the line continues), NaN if
  // the report was invalid (a gap).
  function table(columns) {
    const rows = new Map();
    columns.forEach((column, place) => {
      column.t.forEach((t, i) => {
        if (!rows.has(t)) rows.set(t, [t].concat(new Array(columns.length).fill(null)));
        rows.get(t)[place + 1] = column.v[i] === null ? NaN : column.v[i];
      });
    });
    if (rows.size === 0) return [[0].concat(new Array(columns.length).fill(NaN))];
    return Array.from(rows.values()).sort((a, b) => a[0] - b[0]);
  }

  // An untrusted interval extends to the first trusted estimate, so that the curve has no hole.
  function estimates(outlet, trusted) {
    const shown = { t: [], v: [] };
    outlet.e.t.forEach((t, i) => {
      const isTrusted = outlet.e.trusted[i] === 1;
      const endsDoubt = !trusted && i > 0 && outlet.e.trusted[i - 1] !== 1;
      if (isTrusted !== trusted && !endsDoubt) return;
      shown.t.push(t);
      shown.v.push(outlet.e.p[i]);
    });
    return shown;
  }

  const marksOf = (outlet) => data.stimulus.concat(outlet.marks).sort((a, b) => a.t - b.t);
  const markColour = (kind) => colour("mark-" + kind.split(".")[0]) || colour("mark-stimulus");

  // A dashed line at each mark, and its name at the bottom if there is room, in several rows if needed.
  function drawMarks(marks, named, context, area, graph) {
    const rowEnds = [];
    context.save();
    context.font = "11px system-ui, sans-serif";
    context.textBaseline = "bottom";
    marks.forEach((mark) => {
      const x = Math.round(graph.toDomXCoord(mark.t)) + 0.5;
      if (x < area.x || x > area.x + area.w) return;
      context.strokeStyle = markColour(mark.kind);
      context.setLineDash(mark.kind === "relay.reported" ? [2, 3] : [5, 3]);
      context.beginPath();
      context.moveTo(x, area.y);
      context.lineTo(x, area.y + area.h);
      context.stroke();
      if (!named) return;
      const width = context.measureText(mark.label).width;
      const left = Math.min(x + 3, area.x + area.w - width - 2);
      let row = 0;
      while (row < rowEnds.length && rowEnds[row] > left) ++row;
      const foot = area.y + area.h - 4 - row * 15;
      if (foot < area.y + 15) return;
      rowEnds[row] = left + width + 8;
      context.globalAlpha = 0.85;
      context.fillStyle = colour("paper");
      context.fillRect(left - 1, foot - 13, width + 2, 14);
      context.globalAlpha = 1;
      context.fillStyle = markColour(mark.kind);
      context.fillText(mark.label, left, foot);
    });
    context.restore();
  }

  function writeLegend(target, known, state) {
    target.textContent = "";
    const add = (text, series) => {
      const item = document.createElement("span");
      if (series) {
        const line = document.createElement("i");
        line.style.borderTopColor = "var(--" + series.colour + ")";
        if (series.dotted) line.className = "dotted";
        item.appendChild(line);
      }
      item.appendChild(document.createTextNode(text));
      target.appendChild(item);
    };
    if (state.x !== undefined) add("t = " + state.x.toFixed(4) + " s");
    state.series.forEach((series, i) => {
      if (!series.isVisible) return;
      const value = state.x !== undefined && Number.isFinite(series.y)
          ? ": " + axisNumber(series.y, known[i].digits) + " " + known[i].unit : "";
      add(known[i].label + value, known[i]);
    });
    return "";
  }

  function options(series, marks, named, more) {
    return Object.assign({
      labels: ["t"].concat(series.map((one) => one.label)),
      colors: series.map((one) => colour(one.colour)),
      connectSeparatedPoints: true,
      dateWindow: [0, data.duration_s],
      strokeWidth: 1.6,
      axisLineColor: colour("line"),
      gridLineColor: colour("line"),
      gridLineWidth: 0.6,
      rightGap: 8,
      underlayCallback: (context, area, graph) => drawMarks(marks, named, context, area, graph),
    }, more);
  }

  const timeAxis = { axisLabelFormatter: (t) => axisNumber(t, 4) + " s" };

  function frequencyGraph(node, outlet, more) {
    const powers = outlet.e.p.filter((p) => p !== null);
    const estimated = powers.length > 0;
    const lowest = Math.min(0, ...powers), highest = Math.max(1, ...powers);
    return new Dygraph(node, table([
      { t: outlet.t, v: outlet.f }, { t: data.reference.t, v: data.reference.f },
      estimates(outlet, true), estimates(outlet, false),
    ]), options(FREQUENCY, marksOf(outlet), true, Object.assign({
      visibility: [true, true, estimated, estimated],
      yRangePad: 10,
      series: {
        [FREQUENCY[2].label]: { axis: "y2", strokeWidth: 2.2 },
        [FREQUENCY[3].label]: { axis: "y2", strokeWidth: 1.8, strokePattern: [2, 3] },
      },
      axes: {
        x: timeAxis,
        y: { axisLabelWidth: AXIS_WIDTH, axisLabelFormatter: (f) => axisNumber(f, 4) + " Hz" },
        y2: {
          axisLabelWidth: AXIS_WIDTH, independentTicks: true, drawGrid: false, drawAxis: estimated,
          valueRange: [lowest * 1.1, highest * 1.1],
          axisLabelFormatter: (p) => axisNumber(p, 0) + " MW",
        },
      },
    }, more)));
  }

  function rocofGraph(node, outlet, more) {
    return new Dygraph(node, table([
      { t: outlet.t, v: outlet.r }, { t: data.reference.t, v: data.reference.r },
    ]), options(ROCOF, marksOf(outlet), false, Object.assign({
      // The same margin on the right as the graph above, so that the time axes are aligned.
      rightGap: 8 + (outlet.e.p.length ? AXIS_WIDTH + 6 : 0),
      axes: {
        x: timeAxis,
        y: { axisLabelWidth: AXIS_WIDTH, axisLabelFormatter: (r) => axisNumber(r, 3) + " Hz/s" },
      },
    }, more)));
  }

  // For printing: images of the same curves in the width and colours of paper. They are made in advance,
  // because a canvas that is drawn when the browser is about to print stays empty.
  let paperGraphs = [];
  let paperTimer = 0;
  function drawPaper() {
    paperGraphs.forEach((graph) => graph.destroy());
    const outlet = data.outlets[choice.value];
    const more = { dateWindow: graphs[0].xAxisRange(), pixelRatio: 2, interactionModel: {} };
    root.setAttribute("data-printing", "");
    paperGraphs = [
      frequencyGraph(element("frequency-paper"), outlet, more),
      rocofGraph(element("rocof-paper"), outlet, more),
    ];
    root.removeAttribute("data-printing");
    document.querySelectorAll(".paper canvas").forEach((canvas) => {
      const picture = new Image();
      picture.alt = "";
      picture.src = canvas.toDataURL();
      picture.style.cssText = canvas.style.cssText;
      canvas.replaceWith(picture);
    });
  }
  function drawPaperSoon() {
    clearTimeout(paperTimer);
    paperTimer = setTimeout(drawPaper, 150);
  }

  let graphs = [];
  let following = false;
  function follow(graph, initial) {
    if (initial || following) return;
    following = true;
    graphs.forEach((other) => {
      if (other !== graph) other.updateOptions({ dateWindow: graph.xAxisRange() });
    });
    following = false;
    drawPaperSoon();
  }

  function show(range) {
    graphs[0].updateOptions({ dateWindow: range });
  }

  function draw() {
    const range = graphs.length ? graphs[0].xAxisRange() : [0, data.duration_s];
    graphs.forEach((graph) => graph.destroy());
    graphs = [];
    const outlet = data.outlets[choice.value];
    const onScreen = (series, legend) => ({
      dateWindow: range,
      legend: "always",
      labelsDiv: document.createElement("div"),
      legendFormatter: (state) => writeLegend(legend, series, state),
      highlightCircleSize: 3,
      drawCallback: follow,
    });
    graphs = [
      frequencyGraph(element("frequency-plot"), outlet, onScreen(FREQUENCY, element("frequency-legend"))),
      rocofGraph(element("rocof-plot"), outlet, onScreen(ROCOF, element("rocof-legend"))),
    ];
    drawPaper();
    window.gsbenchGraphs = graphs;
  }

  // From shortly before the first mark to shortly after the last mark within 10 s of it.
  function aroundTheEvent() {
    const marks = marksOf(data.outlets[choice.value]);
    const first = marks.length ? marks[0].t : 0;
    const last = Math.max(first + 1, ...marks.map((mark) => mark.t).filter((t) => t < first + 10));
    return [Math.max(0, first - 0.5), Math.min(data.duration_s, last + 1)];
  }

  choice.addEventListener("change", draw);
  element("zoom-all").addEventListener("click", () => show([0, data.duration_s]));
  element("zoom-event").addEventListener("click", () => show(aroundTheEvent()));
  element("overview").addEventListener("click", (event) => {
    const row = event.target.closest("tr[data-outlet]");
    if (!row) return;
    if (event.target.closest("a")) element("outlet-" + row.dataset.outlet).open = true;
    choice.value = row.dataset.outlet;
    draw();
  });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);

  // When printing, the tables of all outlets are open.
  let opened = [];
  window.addEventListener("beforeprint", () => {
    root.setAttribute("data-printing", "");
    opened = Array.from(document.querySelectorAll("details:not([open])"));
    opened.forEach((details) => { details.open = true; });
  });
  window.addEventListener("afterprint", () => {
    root.removeAttribute("data-printing");
    opened.forEach((details) => { details.open = false; });
  });

  choice.value = choice.dataset.first;  // also after a reload
  draw();
})();
