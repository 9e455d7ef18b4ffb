// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/go_to_place.h"

#include "journal/message_fields.h"
#include "vocabulary/sentence.h"

#include <QWidget>

namespace codewheel {

GoToPlace::GoToPlace(QWidget *view)
    : QAction(view)
{
    setShortcut(Qt::CTRL | Qt::Key_G);
    setShortcutContext(Qt::WidgetWithChildrenShortcut);
    setToolTip(tr("Choose in the bus structure what the row is about (Ctrl+G)"));
    view->addAction(this);
    connect(this, &QAction::triggered, this, [this] {
        if (m_place)
            Q_EMIT wanted(*m_place);
    });
    setPlace({});
}

void GoToPlace::setPlace(std::optional<Place> place)
{
    m_place = place;
    setEnabled(place.has_value());
    setText(place ? sentence(tr("Go to %1", "a device or a bus"), {placeName(place)})
                  : tr("Go to the device"));
}

} // namespace codewheel
