// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>
#include <QSignalBlocker>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace codewheel {

// Folds the panels at the bottom of the window to their tabs, so that a page gets their height and no key
// reaches them, and brings them back as they were, as does clicking a tab or anything that shows one of them.
// Floating panels, and those elsewhere, are left alone.
class BottomFold : public QObject
{
    Q_OBJECT

public:
    explicit BottomFold(QMainWindow &window);

    void fold();
    void unfold();
    bool isFolded() const { return m_isFolded; }
    bool isFolded(const QDockWidget &panel) const { return m_isFolded && m_folded.contains(&panel); }

    // Unfolds while the layout of the window is being saved or restored.
    class Pause
    {
    public:
        explicit Pause(BottomFold &fold)
            : m_fold(fold)
            , m_wasFolded(fold.isFolded())
        {
            const QSignalBlocker forNow(m_fold);
            m_fold.unfold();
        }
        ~Pause()
        {
            const QSignalBlocker asBefore(m_fold);
            if (m_wasFolded)
                m_fold.fold();
        }
        Pause(const Pause &) = delete;
        Pause &operator=(const Pause &) = delete;

    private:
        BottomFold &m_fold;
        const bool m_wasFolded;
    };

Q_SIGNALS:
    void foldedChanged(bool folded);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void foldPanel(QDockWidget &panel);
    bool isOfFolded(const QTabBar &tabs, const QPoint &pressed) const;

    QMainWindow &m_window;
    bool m_isFolded = false;
    QHash<const QDockWidget *, int> m_folded; // with their previous heights
};

} // namespace codewheel
