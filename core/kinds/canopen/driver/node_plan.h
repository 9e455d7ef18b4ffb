// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "catalog/device_description.h"
#include "kinds/canopen/driver/node_driver.h"
#include "kinds/canopen/protocol/canopen_reach.h"

namespace codewheel::canopen {

// A step of a job as carried out by the driver of a node. Step::line is "6001:0" for a read, "6001:0=5000"
// for a write, "6000:0 b0=1 b2=0" for bits that are changed, "NMT 129" for a command.
struct NodeStep : Step
{
    enum class Task : std::uint8_t {
        read,     // the values are part of the outcome
        refresh,  // only what is known is brought up to date; it may fail
        bits,     // before some of its bits are written: the others stay as they are
        write,    // sent once
        readBack, // what was written must be found
        positionBefore,
        positionAfter,
        preset, // sent once
        store,
        restore, // the factory values
        vendor,  // an object of the maker is written to that make only
        readCam,
        writeCam,
        nmt,
        bootUp,  // after a reset
        started, // the node runs again
    };

    Task task = Task::read;
    SdoObject object{};
    std::uint32_t number = 0; // preset, signatures, values of cams
    ParameterValues values{}; // write, readBack
    CamField cam{};
    NmtCommand command = NmtCommand::start;
};
using NodeSteps = std::vector<NodeStep>;

// What a job means in requests, step by step (CiA 301, CiA 406). No I/O; what is read on the way refines it
// (NodeJob).
class NodePlan
{
public:
    NodePlan(const DeviceDescription &device, ParameterValues known,
             const std::optional<KnownCams> &cams = {})
        : m_device(device)
        , m_known(std::move(known))
        , m_cams(cams)
    {}

    // Whether the job suits this encoder: bad input is refused here.
    Result<void> check(const Job &job) const;
    NodeSteps stepsFor(const Job &job) const;

    // Scaling that is switched off goes first and one that is switched on last, since resolution and range
    // act at once while it is on. Bits of one object are written together.
    NodeSteps writes(const ParameterValues &values) const;
    NodeSteps cams(const CamProgram &program, const std::optional<CamProgram> &has) const;
    NodeStep readBack(const NodeStep &write) const;
    static NodeStep store();
    static NodeStep nmt(NmtCommand command);
    static NodeStep started();

private:
    NodeSteps steps(const ReadParameters &job) const;
    NodeSteps steps(const WriteParameters &job) const;
    NodeSteps steps(const SetPreset &job) const;
    NodeSteps steps(const ResetToDefault &job) const;
    NodeSteps steps(const ReadCams &job) const;
    NodeSteps steps(const WriteCams &job) const;
    NodeSteps steps(const StoreParameters &job) const;

    void appendReads(NodeSteps &steps, NodeStep::Task task, const std::vector<Parameter> &parameters) const;
    void appendRefresh(NodeSteps &steps, std::initializer_list<Parameter> parameters) const;
    void appendWrites(NodeSteps &steps, const ParameterValues &values) const;
    const CanopenReach &reachOf(Parameter parameter) const;
    NodeStep write(const ParameterValues &values) const;

    const DeviceDescription &m_device;
    ParameterValues m_known;
    std::optional<KnownCams> m_cams;
};

// The object that holds this of the cams: the first channel's.
SdoObject camObject(CamField field);
// The fields that the cams of this device have, in the order in which they are written.
std::vector<CamField> camFieldsOf(const CamAbilities &cams);

// What moves or scales the position.
bool isOfPosition(Parameter parameter);

} // namespace codewheel::canopen
