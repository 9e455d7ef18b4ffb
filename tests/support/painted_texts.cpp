// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/painted_texts.h"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QWidget>

namespace codewheel::test {
namespace {

class TextEngine final : public QPaintEngine
{
public:
    explicit TextEngine(const QRectF &widget)
        : QPaintEngine(AllFeatures)
        , m_widget(widget)
    {}

    std::vector<PaintedText> takeTexts() { return std::move(m_texts); }

    bool begin(QPaintDevice *) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState &) override {}
    void drawPath(const QPainterPath &) override {}
    void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
    void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
    void drawTiledPixmap(const QRectF &, const QPixmap &, const QPointF &) override {}
    void drawImage(const QRectF &, const QImage &, const QRectF &, Qt::ImageConversionFlags) override {}

    void drawTextItem(const QPointF &where, const QTextItem &item) override
    {
        const QString text = item.text().trimmed();
        if (text.isEmpty())
            return;
        const QTransform &toWidget = painter()->deviceTransform();
        const QRectF line(where - QPointF(0, item.ascent()),
                          QSizeF(item.width(), item.ascent() + item.descent()));
        const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(where) & line;
        QRectF room = m_widget;
        if (painter()->hasClipping())
            room &= toWidget.mapRect(painter()->clipBoundingRect());
        m_texts.push_back({text, toWidget.mapRect(ink), room});
    }

private:
    QRectF m_widget;
    std::vector<PaintedText> m_texts;
};

class TextDevice final : public QPaintDevice
{
public:
    explicit TextDevice(const QWidget &widget)
        : m_widget(widget)
        , m_engine(widget.rect())
    {}

    TextEngine &engine() { return m_engine; }
    QPaintEngine *paintEngine() const override { return &m_engine; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
            return m_widget.width();
        case PdmHeight:
            return m_widget.height();
        case PdmDpiX:
        case PdmPhysicalDpiX:
            return m_widget.logicalDpiX();
        case PdmDpiY:
        case PdmPhysicalDpiY:
            return m_widget.logicalDpiY();
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        case PdmDevicePixelRatio:
            return 1;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    const QWidget &m_widget;
    mutable TextEngine m_engine;
};

} // namespace

std::vector<PaintedText> paintedTexts(QWidget &widget)
{
    TextDevice device(widget);
    widget.render(&device, {}, {}, {});
    return device.engine().takeTexts();
}

} // namespace codewheel::test
