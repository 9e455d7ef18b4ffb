// SPDX-License-Identifier: GPL-3.0-or-later
// What an empty Qt window costs on this machine, with the libraries of the program loaded: the baseline for
// our first paint.
#include "app/window/start_probe.h"

#include <QApplication>
#include <QMainWindow>
#include <QTimer>

namespace {

class EmptyWindow : public QMainWindow
{
protected:
    bool event(QEvent *event) override
    {
        const bool handled = QMainWindow::event(event);
        if (event->type() == QEvent::Paint && !m_painted) {
            m_painted = true;
            QTimer::singleShot(0, this, [] {
                codewheel::reportFirstPaint();
                codewheel::reportMemory();
                QCoreApplication::exit();
            });
        }
        return handled;
    }

private:
    bool m_painted = false;
};

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    EmptyWindow window;
    window.resize(1280, 800);
    window.show();
    return QApplication::exec();
}
