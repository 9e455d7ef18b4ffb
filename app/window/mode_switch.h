// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLabel;

namespace codewheel {

class ModePart;

// Watch | Operate as one switch: one of two, as radio buttons are, told by what is filled and what is bold
// and not by a colour alone. Where there are several buses, the name of the one that is meant stands before
// it.
class ModeSwitch : public QWidget
{
    Q_OBJECT

public:
    ModeSwitch(QAction &watch, QAction &operate, QWidget *parent = nullptr);

    void tellBus(const QString &name); // empty: there is no doubt

    // What is shown where room is short; the names of its parts tell the rest.
    enum class Shown : std::uint8_t { all, words, icons };
    void showOnly(Shown what);
    int widthOf(Shown what) const;

private:
    QLabel *m_name;
    ModePart *m_watch;
    ModePart *m_operate;
};

} // namespace codewheel
