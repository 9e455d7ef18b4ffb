// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <QFrame>
#include <QPointer>
#include <QStringList>
#include <QTimer>

#include <memory>

class QLabel;
class QLineEdit;
class QListView;

namespace codewheel {

class PaletteModel;

// A field over the middle of a window, and below it everything that the words in it find: Return or a click
// carries it out, Esc gives the focus back. The window's own keys go on working.
class CommandPalette : public QFrame
{
    Q_OBJECT

public:
    explicit CommandPalette(QWidget &window);
    ~CommandPalette() override;

    void addSource(std::unique_ptr<PaletteSource> source);
    void setUsed(const QStringList &ids); // last one first; see PaletteEntry::id

    void open();
    bool isComplete() const { return m_source == m_sources.size(); } // all sources have given all

Q_SIGNALS:
    void used(const QString &id);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool takeKey(int key, Qt::KeyboardModifiers modifiers);
    void gather();
    void filter();
    void showFound();
    void move(int by, bool isCircular);
    void choose(int row);
    void announce();
    void run(int row);
    void close();
    void leave();
    void place();
    bool isOurs(const QObject *object) const;

    QWidget &m_window;
    std::vector<std::unique_ptr<PaletteSource>> m_sources;
    std::size_t m_source = 0; // being asked
    PaletteModel *m_model;
    QLineEdit *m_field;
    QListView *m_list;
    QLabel *m_nothing;
    QLabel *m_note;
    QTimer m_gathering;
    bool m_isOpen = false;
    bool m_hasMoved = false;                      // since the last letter
    std::vector<QPointer<QWidget>> m_focusBefore; // and what it is in, should it be gone
};

} // namespace codewheel
