// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "cli/call/arguments.h"
#include "cli/call/subcommand.h"
#include "project/project.h"
#include "vocabulary/encoder_session.h"

#include <QtGlobal>

#include <set>

namespace codewheel {

// --device of the commands that work on a PLACE.
inline constexpr Option deviceOption{
    "--device", "NAME",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "treat the encoder as this one: a name from \"devices\", or the key on its label")};

// The place typed as `typed`: a place as its kind of bus writes it, on the one bus of the call that has it;
// the station of a device of the project; or either of them after the name of a bus or its number, "Crane
// 2/1.0". Refused if several are possible, with the choices. A place written in full takes precedence over a
// station of the same text, and that over a short form ("05").
Checked<Place> placeMeant(const Call &call, const Project *project, const QString &typed);

// The bus of the call with this name, otherwise with this number.
Checked<BusAccess *> busNamed(const Call &call, const QString &name);

// "bus", its number, "busName" and "place", for programs.
QJsonObject placeJson(const Call &call, Place place, QJsonObject more = {});
void addPlace(QJsonObject &json, const Call &call, Place place);
void addBus(QJsonObject &json, const BusAccess &bus); // "bus" and "busName"

// The encoder at the PLACE the call names, to the point that it shows its position. With --device it is named
// first, for this call.
Checked<EncoderSession *> encoderAt(const Call &call);
// The same for each of the arguments of the call.
Checked<std::set<Place>> encodersAt(const Call &call);
// The one at `typed`, whatever --device says.
Checked<EncoderSession *> encoderAt(const Call &call, const QString &typed);

// For a command on one encoder: carried out on the one that encoderAt() finds; its answer gives place and
// device.
template <Checked<Answer> (*command)(const Call &, EncoderSession &)>
Checked<Answer> atPlace(const Call &call)
{
    return encoderAt(call).and_then([&](EncoderSession *encoder) {
        const Place place = encoder->place(); // that was meant
        auto answer = command(call, *encoder);
        if (answer) {
            addPlace(answer->json, call, place);
            answer->json.insert(QStringLiteral("device"), encoder->device().key);
        }
        return answer;
    });
}

// What a name from the catalog, or the key on a label, means at a place of the bus. 0: the key does not give
// it.
struct NamedDevice
{
    QString key;
    int turns = 0;
    int stepsPerTurn = 0;
};
Checked<NamedDevice> deviceMeant(const Call &call, Place place, const QString &typed);
// Names the device at the place as --device says, if it is given.
Checked<void> nameDevice(const Call &call, Place place);

std::vector<BusAccess *> busesOf(const Call &call, const QString &kind); // of this kind
// The bus of this kind that --bus names; without it the only one of the link. Refused if it leads to none, or
// to several.
Checked<BusAccess *> busMeant(const Call &call, const QString &kind);
// The ring of --fault-plan, which --fault-bus names if there are several.
Checked<BusAccess *> ringOfFaults(const Call &call);
inline constexpr Option faultBusOption{
    "--fault-bus", "BUS",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "the ring of the fault plan, as the project calls it, where there are several")};
inline constexpr Option busOption{
    "--bus", "BUS",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "on this bus, as the project calls it, where there are several")};

} // namespace codewheel
