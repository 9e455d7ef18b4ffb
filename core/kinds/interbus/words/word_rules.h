// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/protocol_rules.h"

namespace codewheel {

// For encoders that receive values in words.
class WordRules : public ProtocolRules
{
public:
    bool hasParameters() const override { return true; }

    void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                        const DeviceDescription &device) const override;

private:
    virtual void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                            const DeviceDescription &device) const = 0;
    void checkRange(const JsonObject &row, const ParameterDescription &parameter) const;
};

} // namespace codewheel
