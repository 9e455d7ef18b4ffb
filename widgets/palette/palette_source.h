// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

#include <functional>
#include <utility>
#include <vector>

namespace codewheel {

// Whether an entry can be carried out now, and why not, if that is known.
struct PaletteState
{
    bool isEnabled = true;
    QString reason{};
};

// What the command palette finds: an action, a device, and so on.
struct PaletteEntry
{
    enum class Kind : std::uint8_t { action, device, parameter, message, manual };

    Kind kind = Kind::action;
    QString id{}; // the same in each run and language: the last ones used are kept by it; empty: not kept
    QString title{};
    QString context{}; // where it is: its menu, its bus
    QString key{};
    QString does{};  // what Return does
    QString words{}; // by which it is found, too
    QIcon icon{};
    bool isUsual = false; // offered before anything is typed
    std::function<void()> run{};
    std::function<PaletteState()> state{}; // null: always enabled
};

// Where the palette's entries come from. A source that has many gives them in parts, so that the palette can
// be used meanwhile.
class PaletteSource
{
public:
    virtual ~PaletteSource() = default;

    virtual void begin() = 0;                     // the palette opens: as everything is now
    virtual std::vector<PaletteEntry> next() = 0; // the next part; empty: that was all
};

// Gives all its entries as one part, as they are at that moment.
class PaletteOfOnePart final : public PaletteSource
{
public:
    explicit PaletteOfOnePart(std::function<std::vector<PaletteEntry>()> entries)
        : m_entries(std::move(entries))
    {}

    void begin() override { m_isGiven = false; }
    std::vector<PaletteEntry> next() override
    {
        return std::exchange(m_isGiven, true) ? std::vector<PaletteEntry>() : m_entries();
    }

private:
    const std::function<std::vector<PaletteEntry>()> m_entries;
    bool m_isGiven = false;
};

} // namespace codewheel
