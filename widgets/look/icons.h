// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include <cstdint>

namespace codewheel {

enum class Role : std::uint8_t;

// Our own line icons, resources/icons/<name>.svg: setBit is set-bit.svg.
enum class Icon : std::uint8_t {
    add,
    alarmStop,
    attention,
    back,
    battery,
    cams,
    cancel,
    compare,
    computer,
    copy,
    details,
    down,
    drive,
    encoder,
    exportData,
    fault,
    file,
    filter,
    folder,
    home,
    inactive,
    information,
    list,
    master,
    messages,
    monitor,
    newFolder,
    next,
    ok,
    open,
    operate,
    parameters,
    paste,
    pause,
    pin,
    playBack,
    power,
    preset,
    question,
    read,
    record,
    refresh,
    remove,
    ring,
    running,
    save,
    search,
    sequence,
    setBit,
    shaft,
    start,
    step,
    stepBack,
    stop,
    toBegin,
    toEnd,
    trace,
    training,
    trend,
    turnLeft,
    turnRight,
    up,
    watch,
    wizard,
    write,
};
inline constexpr int iconCount = static_cast<int>(Icon::write) + 1;

// Drawn in the text colour the application palette has when it is painted, or in that of a role; strokes are
// 1.5 px wide at 16 and at 24 px, crisp at any device pixel ratio.
QIcon lineIcon(Icon icon);
QIcon lineIcon(Icon icon, Role role);

} // namespace codewheel
