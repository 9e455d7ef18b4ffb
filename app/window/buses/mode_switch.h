// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLabel;

namespace codewheel {

class ModePart;

// Watch | Operate as one switch: a choice between two, as with radio buttons, shown by fill and bold type and
// not by colour alone. If there are several buses, the name of the one it applies to comes first.
class ModeSwitch : public QWidget
{
    Q_OBJECT

public:
    ModeSwitch(QAction &watch, QAction &operate, QWidget *parent = nullptr);

    void tellBus(const QString &name); // empty: there is only one it could be

    // What is shown where room is short; the accessible names say the rest.
    enum class Shown : std::uint8_t { all, words, icons };
    void showOnly(Shown what);
    int widthOf(Shown what) const;

private:
    QLabel *m_name;
    ModePart *m_watch;
    ModePart *m_operate;
};

} // namespace codewheel
