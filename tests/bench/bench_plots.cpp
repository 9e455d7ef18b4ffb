// SPDX-License-Identifier: GPL-3.0-or-later
// What bench_trend measures, in other charts: QCustomPlot, where it is installed, and a line series of Qt
// Charts.
#include "tests/bench/noisy_shaft.h"
#include "tests/bench/painted_frames.h"
#include "tests/bench/processor_time.h"

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QLineSeries>
#include <QValueAxis>

#ifdef CODEWHEEL_HAS_QCUSTOMPLOT
#include <qcustomplot.h>
#endif

#include <cstdio>

namespace {

using namespace codewheel;

constexpr QSize chartSize(1000, 600);

void show(QWidget &chart)
{
    chart.resize(chartSize);
    chart.show();
    QApplication::processEvents();
}

void print(const char *what, int samples, const bench::FrameTimes &times)
{
    std::printf("%s, %d samples in view: median %.2f ms a frame, longest %.2f ms\n", what, samples,
                times.median, times.longest);
}

#ifdef CODEWHEEL_HAS_QCUSTOMPLOT
void measureQCustomPlot(int inView, int frames)
{
    QCustomPlot plot;
    QVector<QCPGraphData> data;
    bench::NoisyShaft shaft;
    for (int i = 0; i < inView + inView / 2; ++i)
        data.push_back({static_cast<double>(i), static_cast<double>(shaft.next())});
    plot.addGraph();
    plot.graph()->data()->set(data, true);
    plot.graph()->rescaleValueAxis();
    show(plot);
    const double pixel = static_cast<double>(inView) / plot.axisRect()->width();
    print("QCustomPlot", inView, bench::timesOf(frames, [&](int frame) {
              plot.xAxis->setRange(frame * pixel, frame * pixel + inView);
              plot.replot(QCustomPlot::rpQueuedReplot);
              bench::paint(plot);
          }));
}
#else
void measureQCustomPlot(int inView, int)
{
    std::printf("QCustomPlot, %d samples in view: not measured, libqcustomplot-dev is not installed\n",
                inView);
}
#endif

void measureQtCharts(int inView, int frames)
{
    QChartView view(new QChart);
    auto *series = new QLineSeries;
    QList<QPointF> points;
    bench::NoisyShaft shaft;
    for (int i = 0; i < inView + inView / 2; ++i)
        points.push_back({static_cast<double>(i), static_cast<double>(shaft.next())});
    series->replace(points);
    view.chart()->addSeries(series);
    view.chart()->createDefaultAxes();
    view.chart()->legend()->hide();
    show(view);
    const double pixel = inView / view.chart()->plotArea().width();
    print(
        "Qt Charts", inView, bench::timesOf(frames, [&](int frame) {
            view.chart()->axes(Qt::Horizontal).constFirst()->setRange(frame * pixel, frame * pixel + inView);
            bench::paint(*view.viewport());
        }));
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    measureQCustomPlot(10'000, 200);
    measureQCustomPlot(1'000'000, 100);
    measureQCustomPlot(10'000'000, 20);
    measureQtCharts(10'000, 50);
    measureQtCharts(100'000, 20);
    return 0;
}
