'use strict';
// One plot for each placeholder of the page. Gaps are null.
for (const [number, plot] of JSON.parse(document.getElementById('plots').textContent).entries()) {
  const rows = plot.x.map((x, row) => [x, ...plot.curves.map((curve) => curve.y[row])]);
  new Dygraph(document.getElementById(`plot-${number}`), rows, {
    labels: [plot.x_axis, ...plot.curves.map((curve) => curve.name)],
    xlabel: plot.x_axis,
    ylabel: plot.y_axis,
    stepPlot: plot.steps,
    fillGraph: plot.steps && plot.curves.length === 1,
    labelsDiv: document.getElementById(`legend-${number}`),
    legend: 'always',
    connectSeparatedPoints: false,
    strokeWidth: 1.5,
    axes: { y: { axisLabelWidth: 70 } },
  });
}
