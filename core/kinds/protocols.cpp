// SPDX-License-Identifier: GPL-3.0-or-later
// What the library of protocols has of every kind: another kind has a row in each list that it has something
// for.
#include "can/can_refusals.h"
#include "can/frame_meaning.h"
#include "catalog/protocol_rules.h"
#include "jobs/protocol.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/canopen_protocols.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/canopen_explain.h"
#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/simulator/can_training_acts.h"
#include "kinds/esc/esc_protocols.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/offer_messages.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/simulator/ring_training_acts.h"
#include "kinds/interbus/words/device_number.h"
#include "kinds/interbus/words/k3_cam_effect.h"
#include "kinds/interbus/words/profiles.h"
#include "kinds/interbus/words/word_refusals.h"
#include "vocabulary/find_by.h"
#include "vocabulary/place.h"
#include "vocabulary/texts_of_kinds.h"

#include <algorithm>
#include <array>
#include <vector>

namespace codewheel {

// For a kind of bus without a row here, a place is read only with the number of its bus.
std::span<const PlaceFormat> placeFormats()
{
    const auto ofRing = [](QStringView text) -> std::optional<NodeId> {
        const auto number = DeviceNumber::parse(text);
        return number ? std::optional(number->node()) : std::nullopt;
    };
    const auto ofLine = [](QStringView text) -> std::optional<NodeId> {
        const auto address = addressTyped(text);
        return address ? std::optional(address->node()) : std::nullopt;
    };
    const auto ofCanBus = [](QStringView text) -> std::optional<NodeId> {
        const auto address = CanopenAddress::read(text);
        return address ? std::optional(address->place()) : std::nullopt;
    };
    static const std::array formats{PlaceFormat{firstBus, ofRing}, PlaceFormat{firstLine, ofLine},
                                    PlaceFormat{firstCanBus, ofCanBus}};
    return formats;
}

namespace {

std::vector<ProtocolKind> &protocolKinds()
{
    static std::vector<ProtocolKind> kinds{
        {profile::k1, k1Rules(), k3Protocol()},
        {profile::k2, k2Rules(), k3Protocol()},
        {profile::k3, k3Rules(), k3Protocol()},
        {profile::k4, k4Rules(), k3Protocol()},
        {profile::la66, la66Rules(), la66Protocol()},
        {profile::esc, escRules(), escProtocol()},
        {profile::cia406, canopenRules(), canopenProtocol()},
    };
    return kinds;
}

const ProtocolKind *kindOf(Profile profile)
{
    return findBy(protocolKinds(), profile, &ProtocolKind::profile);
}

} // namespace

std::vector<Profile> allProfiles()
{
    std::vector<Profile> profiles;
    for (const ProtocolKind &kind : protocolKinds())
        profiles.push_back(kind.profile);
    return profiles;
}

namespace {

std::vector<const RefusalFamily *> &familiesOfRefusals()
{
    static std::vector<const RefusalFamily *> families{&commonRefusals,     &canRefusals, &canopenRefusals,
                                                       &canopenBusRefusals, &escRefusals, &wordRefusals,
                                                       &gatewayRefusals,    &ringRefusals};
    return families;
}

std::vector<const MessageFamily *> &familiesOfMessages()
{
    static std::vector<const MessageFamily *> families{
        &commonMessages, &escMessages, &offerMessages, &ringMessages, &canopenMessages, &canopenBusMessages};
    return families;
}

} // namespace

std::span<const RefusalFamily *const> refusalFamilies()
{
    return familiesOfRefusals();
}

std::span<const MessageFamily *const> messageFamilies()
{
    return familiesOfMessages();
}

void addRefusals(const RefusalFamily &family)
{
    familiesOfRefusals().push_back(&family);
}

void addMessages(const MessageFamily &family)
{
    familiesOfMessages().push_back(&family);
}

void addProtocol(const ProtocolKind &kind)
{
    protocolKinds().push_back(kind);
}

const ProtocolRules &protocolRules(Profile profile)
{
    static const ProtocolRules ofNone;
    const ProtocolKind *kind = kindOf(profile);
    return kind != nullptr ? kind->rules : ofNone;
}

std::optional<QString> textOfTrainingAct(const TrainingAct &act)
{
    for (const auto textOf : {ringActText, lineActText, canActText})
        if (auto text = textOf(act))
            return text;
    return std::nullopt;
}

std::vector<FrameMeaning> newFrameMeanings()
{
    return {canopen::frameMeaning()};
}

QString textOfTyped(const std::vector<RefusalArgument> &typed)
{
    return esc::typedText(typed);
}

QStringList textsWithCamEffect(const std::vector<RefusalArgument> &arguments)
{
    return k3::camWordTexts(arguments);
}

const Protocol &protocolOf(const DeviceDescription &device)
{
    const ProtocolKind *kind = kindOf(device.profile);
    return kind != nullptr ? kind->protocol : noProtocol();
}

} // namespace codewheel
