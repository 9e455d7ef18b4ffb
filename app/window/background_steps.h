// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace codewheel {

// Work done step by step in a thread of its own, since every step may wait for something outside. What a step
// brings is taken in the caller's thread.
class BackgroundSteps : public QObject
{
    Q_OBJECT

public:
    using Taken = std::function<void()>;

    class Work
    {
    public:
        virtual ~Work() = default;
        // Does one step; what is to be done with it in the caller's thread. Empty: there are no more.
        virtual Taken step() = 0;
        virtual void interrupt() = 0; // ends a step that waits. Any thread
    };

    explicit BackgroundSteps(QObject *parent = nullptr);
    ~BackgroundSteps() override; // ends it

    void start(std::unique_ptr<Work> work); // ends one that is running, whose steps are taken no more
    void cancel();                          // after the present step; ends with ended()
    bool isRunning() const { return m_run != nullptr; }

Q_SIGNALS:
    void ended();

private:
    struct Run;

    void fetch();

    std::unique_ptr<Run> m_run;
    QTimer m_looks;
};

} // namespace codewheel
