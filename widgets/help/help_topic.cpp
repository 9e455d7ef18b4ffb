// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_topic.h"

#include <QVariant>
#include <QWidget>

namespace codewheel {
namespace {

constexpr auto topicProperty = "helpTopic";

} // namespace

void setHelpTopic(QWidget &widget, const char *topic)
{
    widget.setProperty(topicProperty, QString::fromLatin1(topic));
}

QString helpTopicOf(const QWidget *widget)
{
    for (; widget != nullptr; widget = widget->parentWidget())
        if (QString topic = widget->property(topicProperty).toString(); !topic.isEmpty())
            return topic;
    return {};
}

} // namespace codewheel
