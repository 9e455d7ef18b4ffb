// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the cam ruler.
#include "widgets/cams/cam_circle.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/cams/cam_texts.h"

#include <QKeyEvent>

#include <algorithm>

namespace codewheel {

void CamRuler::chooseCam(std::size_t cam)
{
    m_sheet.setCurrent(std::min(cam, CamProgram::cams - 1));
}

bool CamRuler::focusNextPrevChild(bool next)
{
    const std::size_t now = m_sheet.current();
    if (next ? now + 1 >= CamProgram::cams : now == 0)
        return QWidget::focusNextPrevChild(next);
    chooseCam(next ? now + 1 : now - 1);
    return true;
}

bool CamRuler::zoomByKey(int key)
{
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomIn();
        return true;
    case Qt::Key_Minus:
        zoomOut();
        return true;
    case Qt::Key_0:
        zoomToAll();
        return true;
    default:
        return false;
    }
}

void CamRuler::moveByKey(std::int64_t by)
{
    const std::size_t number = m_sheet.current();
    const Cam &cam = m_sheet.cam(number);
    if (m_grip == CamGrip::bar && (!cam.active || cam_circle::isEmpty(cam)))
        return; // there is none to be moved, or it is off
    const std::int64_t total = m_scale.total();
    if (m_keyGesture == CamDocument::noGesture)
        m_keyGesture = m_sheet.document().newGesture();
    const CamSheet::Gesture gesture = m_keyGesture;
    m_sheet.setCam(number, gripMoved(cam, m_grip, by, total), cam_texts::movement(number, m_grip), gesture);
    m_scale.reveal(m_grip == CamGrip::stop ? m_sheet.cam(number).stop : m_sheet.cam(number).start);
    showView();
}

QList<KeyHelp> CamRuler::keys()
{
    return {
        {keyNames({Qt::Key_Left, Qt::Key_Right}), tr("Moves the cam or its edge by one step")},
        {keyNames({Qt::SHIFT | Qt::Key_Left, Qt::SHIFT | Qt::Key_Right}),
         tr("Moves it to the next line of the ruler")},
        {keyNames({Qt::Key_Home, Qt::Key_End}), tr("Takes the first or the last position of the cam")},
        {keyNames({Qt::Key_Up, Qt::Key_Down}), tr("To another cam")},
        {keyNames({Qt::Key_Space}), tr("Switches what has the focus on or off")},
        {keyNames({Qt::Key_Delete}), tr("Clears the cam")},
        {keyNames({Qt::Key_Escape}), tr("Back to the whole cam")},
        {keyNames({Qt::Key_Plus, Qt::Key_Minus, Qt::Key_0}), tr("Shows fewer positions, or more, or all")}};
}

void CamRuler::keyPressEvent(QKeyEvent *event)
{
    const std::size_t cam = m_sheet.current();
    const std::int64_t step =
        event->modifiers().testFlag(Qt::ShiftModifier) ? m_scale.tickStep(tickDistance()) : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        moveByKey(-step);
        return;
    case Qt::Key_Right:
        moveByKey(step);
        return;
    case Qt::Key_Up:
        chooseCam(cam == 0 ? 0 : cam - 1);
        return;
    case Qt::Key_Down:
        chooseCam(cam + 1);
        return;
    case Qt::Key_Home:
        setGrip(CamGrip::start);
        return;
    case Qt::Key_End:
        setGrip(CamGrip::stop);
        return;
    case Qt::Key_Space:
        togglePart(focusedPart());
        return;
    case Qt::Key_Delete:
        m_sheet.clear(cam);
        return;
    case Qt::Key_Escape:
        if (m_drag)
            endDrag(false);
        else if (m_grip != CamGrip::bar)
            setGrip(CamGrip::bar);
        else
            event->ignore();
        return;
    default:
        break;
    }
    if (!zoomByKey(event->key()))
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
