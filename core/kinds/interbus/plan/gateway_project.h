// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/ring/ring_device.h"
#include "project/project.h"

namespace codewheel {

// For a program that uses an offered ring through this gateway: a project with that ring, under this name,
// and nothing else. Its devices are as planned here if the offered ring has them in the same places; values
// that were known of the encoders here say nothing about those there.
Project gatewayProject(const Project &planned, BusId ring, const RingStructure &offered,
                       const GatewaySettings &gateway, const QString &name);

} // namespace codewheel
