// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/background_steps.h"

#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds betweenFetches{30};

} // namespace

struct BackgroundSteps::Run
{
    explicit Run(std::unique_ptr<Work> itsWork)
        : work(std::move(itsWork))
        , thread([this](const std::stop_token &stop) { goOn(stop); })
    {}
    ~Run() { cancel(); }

    void goOn(const std::stop_token &stop)
    {
        while (!stop.stop_requested()) {
            Taken taken = work->step();
            if (!taken)
                break;
            const std::scoped_lock lock(mutex);
            steps.push_back(std::move(taken));
        }
        const std::scoped_lock lock(mutex);
        isDone = true;
    }
    void cancel()
    {
        thread.request_stop();
        work->interrupt();
    }

    const std::unique_ptr<Work> work;
    std::mutex mutex;
    std::vector<Taken> steps; // not fetched yet
    bool isDone = false;
    std::jthread thread; // ends first
};

BackgroundSteps::BackgroundSteps(QObject *parent)
    : QObject(parent)
{
    m_looks.setInterval(betweenFetches);
    connect(&m_looks, &QTimer::timeout, this, &BackgroundSteps::fetch);
}

BackgroundSteps::~BackgroundSteps() = default;

void BackgroundSteps::start(std::unique_ptr<Work> work)
{
    m_run.reset();
    m_run = std::make_unique<Run>(std::move(work));
    m_looks.start();
}

void BackgroundSteps::cancel()
{
    if (m_run)
        m_run->cancel();
}

// What takes a step may start other work.
void BackgroundSteps::fetch()
{
    std::vector<Taken> steps;
    bool isDone = false;
    {
        const std::scoped_lock lock(m_run->mutex);
        steps = std::exchange(m_run->steps, {});
        isDone = m_run->isDone;
    }
    if (isDone) {
        m_looks.stop();
        m_run.reset();
    }
    for (const Taken &taken : steps)
        taken();
    if (isDone)
        Q_EMIT ended();
}

} // namespace codewheel
