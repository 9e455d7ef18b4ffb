// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

namespace codewheel {

std::unique_ptr<const LinkKind> canLogLinkKind();

} // namespace codewheel
