// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_ruler.h"

#include "widgets/cams/cam_rows.h"
#include "widgets/cams/cam_ruler_painter.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace codewheel {
namespace {

constexpr int margin = 2 * grid::unit; // left and right of the range
constexpr double reach = 8;            // around an edge, where it can be grasped; larger with large controls
constexpr double zoomStep = 1.5;
constexpr int wheelNotch = 120; // QWheelEvent::angleDelta

} // namespace

CamRuler::CamRuler(CamSheet &sheet, QWidget *parent)
    : QWidget(parent)
    , m_sheet(sheet)
{
    installPaintedPartsAccessibility();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Ruler of the cams"));
    const auto repaint = [this] { update(); };
    connect(&sheet, &CamSheet::documentChanged, this, repaint);
    connect(&sheet, &CamSheet::programChanged, this, repaint);
    connect(&sheet, &CamSheet::numberChanged, this, repaint);
    connect(&sheet, &CamSheet::liveChanged, this, repaint);
    connect(&sheet, &CamSheet::largestChanged, this, &CamRuler::takeRange);
    connect(&sheet, &CamSheet::currentChanged, this, [this] { setGrip(CamGrip::bar); });
    takeRange();
    onEvent(this, {QEvent::StyleChange, QEvent::FontChange}, [this] { updateGeometry(); });
    onEvent(this, {QEvent::Leave}, [this] {
        m_hovered.reset();
        update();
    });
    onEvent(this, {QEvent::Resize}, [this] {
        m_scale.setColumns(margin, width() - 2 * margin);
        Q_EMIT viewChanged();
    });
}

void CamRuler::setGrip(CamGrip grip)
{
    m_grip = grip;
    m_keyGesture = CamDocument::noGesture;
    announcePartFocus(*this, focusedPart());
    update();
}

QRect CamRuler::rowRect(std::size_t cam) const
{
    const int height = camRowHeight(*this);
    return {0, camAxisHeight(*this) + static_cast<int>(cam) * height, width(), height};
}

QString CamRuler::partName(int part) const
{
    return cam_texts::name(static_cast<std::size_t>(part));
}

QString CamRuler::partDescription(int part) const
{
    return cam_texts::description(m_sheet, static_cast<std::size_t>(part));
}

bool CamRuler::isPartChecked(int part) const
{
    return m_sheet.cam(static_cast<std::size_t>(part)).active;
}

void CamRuler::togglePart(int part)
{
    const auto cam = static_cast<std::size_t>(part);
    m_sheet.setActive(cam, !m_sheet.cam(cam).active);
    announcePartState(*this, part);
}

QSize CamRuler::sizeHint() const
{
    return {120 * grid::unit, rowRect(m_sheet.abilities().cams - 1).bottom() + 1};
}

QSize CamRuler::minimumSizeHint() const
{
    return {40 * grid::unit, sizeHint().height()};
}

void CamRuler::takeRange()
{
    m_scale.setLargest(m_sheet.largest());
    showView();
}

void CamRuler::showView()
{
    update();
    Q_EMIT viewChanged();
}

void CamRuler::zoomIn()
{
    m_scale.zoom(zoomStep, width() / 2.0);
    showView();
}

void CamRuler::zoomOut()
{
    m_scale.zoom(1 / zoomStep, width() / 2.0);
    showView();
}

void CamRuler::zoomToAll()
{
    m_scale.showAll();
    showView();
}

void CamRuler::scrollTo(double first)
{
    m_scale.scrollTo(first);
    showView();
}

double CamRuler::tickDistance() const
{
    return fontMetrics().horizontalAdvance(cam_texts::position(m_sheet.largest())) + 4 * grid::unit;
}

void CamRuler::paintEvent(QPaintEvent *)
{
    CamRulerPainter painter(*this, tickDistance());
    painter.drawAxis();
    for (std::size_t cam = 0; cam < m_sheet.abilities().cams; ++cam)
        painter.drawRow(cam, m_hovered && m_hovered->cam == cam && m_hovered->canCreate);
    painter.drawPosition();
    if (m_drag)
        painter.drawValues(m_drag->cam, m_drag->grip);
}

std::optional<CamRuler::Hit> CamRuler::hitAt(QPointF point) const
{
    for (std::size_t number = 0; number < m_sheet.abilities().cams; ++number)
        if (rowRect(number).contains(point.toPoint())) {
            const Cam &cam = m_sheet.cam(number);
            return Hit{number, gripAt(cam, point.x(), m_scale, reach * camRowHeight(*this) / 26.0),
                       cam_circle::isEmpty(cam)};
        }
    return std::nullopt;
}

void CamRuler::showCursor(const std::optional<Hit> &hit)
{
    if (hit && hit->grip == CamGrip::bar)
        setCursor(m_drag ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
    else if (hit && hit->grip)
        setCursor(Qt::SizeHorCursor);
    else if (hit && hit->canCreate)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

void CamRuler::mousePressEvent(QMouseEvent *event)
{
    const auto hit = hitAt(event->position());
    if (event->button() != Qt::LeftButton || !hit || m_drag)
        return;
    m_sheet.setCurrent(hit->cam);
    setGrip(hit->grip.value_or(CamGrip::bar));
    if (!hit->grip && !hit->canCreate)
        return;
    m_drag = CamDrag{.cam = hit->cam,
                     .grip = hit->grip.value_or(CamGrip::bar),
                     .creates = !hit->grip,
                     .before = m_sheet.cam(hit->cam),
                     .from = m_scale.positionAt(event->position().x()),
                     .gesture = m_sheet.document().newGesture()};
    showCursor(hit);
}

void CamRuler::mouseMoveEvent(QMouseEvent *event)
{
    if (m_drag) {
        dragTo(event->position().x());
        return;
    }
    const auto hit = hitAt(event->position());
    if (hit != m_hovered) {
        m_hovered = hit;
        showCursor(hit);
        update();
    }
}

void CamRuler::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    endDrag(true);
    showCursor(hitAt(event->position()));
}

void CamRuler::dragTo(double x)
{
    const double position = m_scale.positionAt(x);
    const bool isAtItsBegin = std::abs(x - m_scale.x(m_drag->from)) < 1;
    const Cam cam = isAtItsBegin ? m_drag->before : m_drag->at(position, m_scale);
    const QString what =
        m_drag->creates ? tr("Draw cam %1").arg(m_drag->cam) : cam_texts::movement(m_drag->cam, m_drag->grip);
    m_sheet.setCam(m_drag->cam, cam, what, m_drag->gesture);
}

void CamRuler::endDrag(bool keep)
{
    const CamDrag drag = *m_drag;
    if (!keep)
        m_sheet.setCam(drag.cam, drag.before, {}, drag.gesture);
    m_drag.reset();
    update();
}

void CamRuler::wheelEvent(QWheelEvent *event)
{
    const bool scrolls = event->modifiers().testFlag(Qt::ShiftModifier) || event->angleDelta().x() != 0;
    const int delta = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double notches = static_cast<double>(delta) / wheelNotch;
    if (scrolls)
        m_scale.scrollTo(m_scale.first() - notches * m_scale.shown() / 10);
    else
        m_scale.zoom(std::pow(zoomStep, notches), event->position().x());
    showView();
    event->accept();
}

void CamRuler::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason)
        chooseCam(0);
    else if (event->reason() == Qt::BacktabFocusReason)
        chooseCam(m_sheet.abilities().cams - 1);
    announcePartFocus(*this, focusedPart());
    update();
}

void CamRuler::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    m_keyGesture = CamDocument::noGesture;
    update();
}

bool CamRuler::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (const auto hit = hitAt(help->pos()))
            QToolTip::showText(help->globalPos(), cam_texts::description(m_sheet, hit->cam), this,
                               rowRect(hit->cam));
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

} // namespace codewheel
