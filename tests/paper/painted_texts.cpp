// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/paper/painted_texts.h"

#include "app/report/sheet_format.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>

namespace codewheel::test {
namespace {

class TextRecorder : public QPaintEngine
{
public:
    TextRecorder()
        : QPaintEngine(AllFeatures)
    {}

    std::vector<PaintedText> take() { return std::move(m_texts); }

    bool begin(QPaintDevice *) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState &) override {}
    void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
    void drawPath(const QPainterPath &) override {}
    void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
    void drawTextItem(const QPointF &at, const QTextItem &item) override
    {
        const QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
        const QRectF clip = painter()->hasClipping() ? painter()->clipBoundingRect() : box;
        if (!item.text().trimmed().isEmpty() && clip.intersects(box.adjusted(6, 6, -6, -6)))
            m_texts.push_back({painter()->transform().mapRect(box), item.text(),
                               !clip.adjusted(-6, -6, 6, 6).contains(box)});
    }

private:
    std::vector<PaintedText> m_texts;
};

class Paper : public QPaintDevice
{
public:
    explicit Paper(TextRecorder &recorder)
        : m_recorder(recorder)
    {}
    QPaintEngine *paintEngine() const override { return &m_recorder; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
            return qRound(sheet::paper.width());
        case PdmHeight:
            return qRound(sheet::paper.height());
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return sheet::dotsPerInch;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    TextRecorder &m_recorder;
};

} // namespace

std::vector<PaintedText> paintedTexts(const ReportPages &pages, int page)
{
    TextRecorder recorder;
    Paper paper(recorder);
    QPainter painter(&paper);
    pages.paint(painter, page);
    painter.end();
    return recorder.take();
}

} // namespace codewheel::test
