// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/manual_headings.h"
#include "widgets/palette/palette_source.h"

#include <QCoreApplication>

#include <functional>

namespace codewheel {

// The pages and headings of the manual for the command palette: as the manual calls them, in English, and by
// the title of the page in the language of the program.
class PaletteManual : public PaletteSource
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::PaletteManual)

public:
    // `show` takes a topic in the form of setHelpTopic().
    explicit PaletteManual(std::function<void(const QString &)> show);

    void begin() override;
    std::vector<PaletteEntry> next() override; // a page

private:
    static QString titleOf(const QString &page);

    const std::function<void(const QString &)> m_show;
    std::vector<ManualHeading> m_headings; // read once
    std::size_t m_next = 0;
};

} // namespace codewheel
