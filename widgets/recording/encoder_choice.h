// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/recording/recording_subjects.h"

#include <QWidget>

class QRadioButton;
class QTreeWidget;

namespace codewheel {

// Which encoders are recorded: all, or those that are ticked.
class EncoderChoice : public QWidget
{
    Q_OBJECT

public:
    EncoderChoice(const std::vector<RecordableEncoder> &encoders, QWidget *parent);

    std::set<Place> places() const; // empty: all
    void setPlaces(const std::set<Place> &places);
    bool isNone() const; // nothing is ticked

Q_SIGNALS:
    void changed();

private:
    std::set<Place> ticked() const;

    QRadioButton *m_all;
    QRadioButton *m_some;
    QTreeWidget *m_list; // parallel to m_places
    std::vector<Place> m_places;
};

} // namespace codewheel
