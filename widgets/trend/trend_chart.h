// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"
#include "widgets/trend/trend_scene.h"

#include <QChartView>
#include <QLocale>

class QCategoryAxis;
class QRubberBand;

namespace codewheel {

class TrendItem;

// The chart of a trend: the only class that knows Qt Charts, which draws axes, grid and labels. It shows a
// scene and asks for another one: by wheel, box, drag and keys.
class TrendChart : public QChartView
{
    Q_OBJECT

public:
    explicit TrendChart(QWidget *parent = nullptr);

    void showScene(const TrendScene &scene);
    void resizeForPaper(QSize size); // without being shown
    QRectF plot() const;             // where curves are, in the widget
    const std::vector<QRectF> &lanes() const;
    // Of one pixel.
    Instant resolution() const;

    QSize sizeHint() const override;
    static QList<KeyHelp> keys(); // that it handles

Q_SIGNALS:
    void spanWanted(const codewheel::TimeSpan &span);
    void scrollWanted(double lengths);
    void zoomWanted(double factor, double at); // as SeenTime::zoom()
    void axisWanted(std::size_t lane, double low, double high);
    void cursorWanted(std::size_t cursor, codewheel::Instant at);

protected:
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    enum class Drag : std::uint8_t { none, pressed, box, time, cursor };

    void showAxes();
    void showItem();
    void useColors();
    void zoomTo(const QRectF &box);
    void moveCursor(int pixels);
    void showToolTip(const QPoint &position, const QPoint &globalPosition);
    std::optional<std::size_t> cursorAt(double x) const;

    QCategoryAxis *m_time;
    QCategoryAxis *m_values;
    TrendItem *m_item;
    QRubberBand *m_box;
    TrendScene m_shown;
    QString m_shownTicks; // of both axes
    QLocale m_locale;
    Drag m_drag = Drag::none;
    QPoint m_pressedAt;
    TimeSpan m_spanBefore{};
};

} // namespace codewheel
