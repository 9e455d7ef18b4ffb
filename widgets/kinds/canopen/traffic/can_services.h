// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {

// What the frames of a bus serve, as far as their identifiers say it by the predefined connection set.
enum class CanService : std::uint8_t { nmt, sync, emcy, pdo, sdo, heartbeat, lss, other };
inline constexpr std::array canServices{CanService::nmt, CanService::sync, CanService::emcy,
                                        CanService::pdo, CanService::sdo,  CanService::heartbeat,
                                        CanService::lss, CanService::other};

CanService canServiceOf(const CanFrame &frame);
QString canServiceText(CanService service);

} // namespace codewheel
