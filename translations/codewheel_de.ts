<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BitText</name>
    <message>
        <source>D31: start (run), when it changes from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D30: initialise the preset; in cam mode: start or stop of a cam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D30: initialise the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D29: FRABA command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D29: ignored by this encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D29: manufacturer specific</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D28..D25: parameter number; in cam mode: number of the cam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D28..D25: parameter number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0: parameter data; D16 with D29 and D21: read out as long as it is 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0: parameter data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D31: position not valid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D30: parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D29: with D31: read-out value or self test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D29: means nothing at this encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D28..D25: parameter number, or error number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0: position, confirmed data or read-out value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0: position or confirmed data</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Choice</name>
    <message>
        <source>CW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CCW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signed, CW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signed, CCW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unsigned, CW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unsigned, CCW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray, CW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray, CCW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset activated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset programmed, not activated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position, as K2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position, as K3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single-turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single-turn, steps minus 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>multi-turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>multi-turn, steps minus 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cam program %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DeviceDescription</name>
    <message>
        <source>%1, make not known</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Meaning</name>
    <message>
        <source>, or: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (there are only %2 to %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: cam start or stop above the largest position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>code %1, which is not defined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong parameter data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown parameter number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters could not be stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faulty value of the code disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an error of the manufacturer&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not defined for this encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal running; the data %1 mean nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run; the other bits (%1) are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initialise the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FRABA preset: activate the preset in every cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2: refused in cam mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to factory settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity mode on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity mode off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out register %1 of the bus chip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cam mode, program %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active cams: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of cam %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop of cam %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position beside the cams shifted by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out the active cams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out the start of cam %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out the stop of cam %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read out the shift of the position beside the cams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (D29 is ignored)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manufacturer specific (D29), and the make is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not defined for this encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position %1 (Gray code %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position %1 in a coding that is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cams on: %1, position part %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processing, data %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Old confirmation: %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Self test, or read-out of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: register %1 of the bus chip = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: active cams %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: start of cam %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: stop of cam %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-out: position beside the cams shifted by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder does not know the read-out code %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No valid position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 2: wrong cam command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manufacturer&apos;s error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D31 D30 = 01: a state in no manual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>Refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bus runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bus is stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ALARM STOP: all OUT words of the ring were set to 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operate: writing is allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch: nothing is sent any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OUT %1 written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written and activated: %3 (parameters: %1, EEPROM writes: %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values read: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset initialised: position %1 before, %2 after.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words sent: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder is in operation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder was left in parameterization. Send run to bring it back to operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder reports error %1 (IN %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder reports no error any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder was powered up again. What was known of it may not hold: read it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bus cycles that came late: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset initialised.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset initialised: position %1 after.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset initialised: position %1 before.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measuring range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset flag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preset flag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>software version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operating time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>operating time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start-up mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multi-turn and steps minus 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>multi-turn and steps minus 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>%1 = %2 is out of range. Give a value from %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Allowed are: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is given twice. Give it once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the %2 can be read but not written. Leave it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to do. Name at least one parameter, value or word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device at %1. There are devices at: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The total range would be %1 steps; the largest is %2. Choose fewer steps or more revolutions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 steps in revolutions %2 are finer than the %3 steps per turn the encoder has. Choose fewer steps or more revolutions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2 is outside the total range. Give a value of at most %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %2 does not have the parameter &quot;%1&quot;. Leave it out, or check which encoder it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 has no read-out: its values cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 cannot be parameterized over the bus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of the %1 cannot be set over the bus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: the mode of the encoder is not known. In cam mode the word %1 %2. Make sure that the encoder is in position mode, and confirm it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A job is running at %1. Wait for its end, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A job is running at this encoder. Wait for its end, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent to %1: a job holds its OUT word. Wait for its end, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: a job holds the OUT word. Wait for its end, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent to %1: the program only watches. Switch to Operate first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: the program only watches. Switch to Operate first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent to %1: the bus is stopped. Start it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: the bus is stopped. Start it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: the encoder is in parameterization already (IN %1). End that first, with run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 1: the encoder refused the value of %1 (IN %2). Check the value and write it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 1: the encoder refused a value (IN %2). Check the values and write them again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 2: the encoder does not know the number of %1 (IN %2). Check which encoder it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 2: the encoder does not know a parameter number (IN %2). Check which encoder it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 3: the encoder has lost its parameters (IN %1). Write parameters 1 to 4 again, or reset it to factory settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 13: the encoder could not store its parameters (IN %1). Write them again; if the error comes back, replace the encoder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 14: the battery of the encoder is low (IN %1). Have it replaced; run brings the encoder back to operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error 15: the encoder reads a faulty value from its code disc (IN %1). Send run; if the error comes back, replace the encoder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder does not know the read-out code %1 (IN %2). Check which encoder it is, and whether it has what you want to read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder reports the manufacturer&apos;s error %1 (IN %2). See its manual.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder gives no valid position (IN %1). Turn the shaft more slowly, and send run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder reports error %1 (IN %2), which its description does not name. See its manual.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder did not answer within %1 s (OUT %2, IN %3). Check which encoder it is, and whether it is switched on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was written as %2 but read back as %3. Read the encoder before you rely on it, and write again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder shows a state that is in no manual (IN %1). Send run, or switch the encoder off and on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The job was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ALARM STOP ended the job. Check in which state it left the encoder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The job ended because the bus was stopped. Start the bus, and check in which state the encoder is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sets the start of cam %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sets the stop of cam %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changes which cams are active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attention</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inactive</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sequence</name>
    <message>
        <source>Nothing was pasted: line %1, &quot;%2&quot;, is no hexadecimal word. Each line takes up to 8 digits of 0 to 9 and A to F.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no word to paste. Copy a column of hexadecimal words first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted: a sequence has at most %1 words.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SequenceFile</name>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is nested too deeply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not valid JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no sequence of words: &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only version %1 of the format can be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;holdCycles&quot; is a whole number from 1 to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;words&quot; is a list of at most %1 words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A word is a text of up to 8 hexadecimal digits, such as &quot;020000FF&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulatedRing</name>
    <message>
        <source>The training bus is not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The words do not match the devices of the training bus.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>%1 – %2</source>
        <comment>meaning of OUT, meaning of IN</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°C</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WordFormat</name>
    <message>
        <source>There is no word here. Type up to 8 hexadecimal digits, such as 020000FF.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no hexadecimal word. Type up to 8 of the digits 0 to 9 and A to F, such as 020000FF.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::BarView</name>
    <message>
        <source>%1 bar</source>
        <comment>IN 1.0 bar</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 to %3</source>
        <comment>value, range</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::Catalog</name>
    <message>
        <source>The file is nested too deeply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not valid JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A device with the key &quot;%1&quot; is in the catalog already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::CodeDisc</name>
    <message>
        <source>Dial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dial of %1</source>
        <comment>device number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <comment>revolutions per minute</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm cw</source>
        <comment>clockwise</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm ccw</source>
        <comment>counter-clockwise</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No position yet. Start the bus and choose an encoder in the bus structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::CommandLine</name>
    <message>
        <source>There is no option &quot;%1&quot; of %2. Its options are: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is given twice. Give it once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes no value. Give it alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a value: %1 %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Give a whole number from %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device at %1 is no encoder this program can drive. See codewheel-cli scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>factory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EEPROM writes: not stated in the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EEPROM writes: about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EEPROM writes: about %1, nothing is guaranteed past %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>list the encoders this program knows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the encoders this program knows. With a NAME: its parameters with their numbers,
read-out codes, factory values and ranges, its errors and how often its EEPROM can be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whose word it is (see devices)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out: master to encoder; in: encoder to master</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mode the encoder is in, if it has several</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the word that stands the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how positions are coded: 1 to 6, or its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Allowed are: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing. Give one of: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 has one coding only. Leave --coding out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of these. What may tell which: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tell what a word means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells what a 32-bit word means to an encoder. Every word gets an answer. What is not told
(mode, coding, the word the other way) widens it to all meanings the word can have.
Needs no bus and sends nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. The commands are: %2. See codewheel-cli --help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name a command: %1. See codewheel-cli --help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is missing. It is called so: codewheel-cli %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too much. It is called so: codewheel-cli %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot;. This version knows one: training, the simulated bus. Leave --link out, or give --link training.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long to look (10)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often to look (100)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>watch the words of an encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks at the words of an encoder every 100 ms and prints a row when they differ from the last look.
Sends nothing. The time is the bus&apos;s own: on the training bus a cycle is 1 ms, and as it runs without
waiting, the answer comes at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>print the words that went over the bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position before: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position after:  %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EEPROM writes:   %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set the position of an encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the encoder show its preset value at the place where its shaft stands. With a VALUE, that is
written as the preset first. Sends at once, without asking.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written to it from here either, so nothing is known of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last written from here:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read the parameters that an encoder has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the parameters named, or all that can be read. While it is read, the encoder shows no
position. An encoder without read-out (devices tells which) is not asked: exit code 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ID code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IN words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OUT words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>list the participants of the bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the participants of the bus in ring order, with their ID codes and words (16 bit each).
The ID code tells the profile but not the make: that is named where the plan of the bus tells it.
Sends nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long a word stands that nothing acknowledges (3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send words as they are, and print what comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends words as they are, one after the other, and prints a row for each change of OUT or IN.
A parameter word stands until the encoder has confirmed it, run (80000000) until it shows a position
or an error, a read-out until it answers; any other word stands for 3 cycles. An error of the encoder
ends the sequence. Words are hexadecimal, as the manuals print them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write without asking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>show what would be written, and send nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write also what the encoder already has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: there is nobody to ask. Add --yes to write, or --dry-run to look only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write this to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>written, and read back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>written, confirmed by the handshake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>was there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>did not become active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder was left in parameterization: it shows no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder was left in error: it shows no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder is in operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write parameters, after showing what and asking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what is known of the parameters, what they shall become, and the words for it; asks; writes them
in the order given, and tells by which evidence they are there. What the encoder already has is not
written again, unless --all is given: it is read first where that is possible, else it is what was
written from here. Where nobody can be asked, --yes is needed: without it nothing is sent, exit code 2.

Parameters: steps revolutions direction coding preset zero-offset offset measuring-range, as far as the
encoder has them (devices NAME). A VALUE is a number or a name: 255, 0xFF, FFh, cw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answer as one JSON object, for programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the way to the bus; &quot;training&quot; (the default) is the simulated one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>explain this and stop; also -h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>print the version and stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device named &quot;%1&quot;. The names are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>codewheel-cli sets up, watches and diagnoses absolute encoders on INTERBUS.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: codewheel-cli COMMAND ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options of every command:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PLACE is the device number of an encoder, segment.position: 1.0. Numbers are decimal unless
they are written 0x.. or ..h; a WORD is always hexadecimal, as the manuals print it.

Each call has a new training bus, which always starts the same: 1.0 FRABA OCD-IB K3 that stands
still, 2.0 Baumer GXP6W K3 that turns at 10 rpm. What one call wrote, the next one does not find.

Exit code: 0 done, 1 the encoder or the bus refused, 2 bad input.
codewheel-cli COMMAND --help explains a command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: codewheel-cli %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. The %2 has: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexadecimal numbers are written 0xFF or FFh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no word. Give up to 8 hexadecimal digits, such as 020000FF.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no PARAMETER=VALUE. Write for example steps=255.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read from the encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confirmed by the handshake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told, not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IN %1, and how it is coded is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y/N</source>
        <comment>answers to a question</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <comment>answer to a question</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <comment>answer to a question</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OUT means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IN means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out: already there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To be written to %1, %2:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder has all of it: there is nothing to write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder is read first, and what it already has is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If it turns out to count steps minus 1, the word of steps carries one less.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::DescriptionReader</name>
    <message>
        <source>A key consists of the letters a to z, digits and hyphens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A generic description has no vendor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last two digits must be those of idCode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This value stands here twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key stands here twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The minimum is larger than the maximum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The factory setting is not between minimum and maximum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The factory setting is none of the choices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A parameter needs a number to write it, a readOut code to read it, or both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This parameter stands here twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This number stands here twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This readOut code stands here twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The budget is larger than eepromLimit.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::DialPanel</name>
    <message>
        <source>&amp;Read what is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No encoder is chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one in the bus structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads what the dial needs from the encoder. That sends words, and takes the position away for some cycles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read what the dial needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In parameterization: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A read-out value stands in IN: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder has no valid position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder shows error %1: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IN %1 is in no manual: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing came from the encoder yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw word %1. The mode is not known: tell the start-up mode under Parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw word %1, in velocity mode: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw word %1, in cam mode: there is no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw word %1. The coding is not known: write it, or tell it under Parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not known: %1. The disc needs it to turn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::DisplayMenu</name>
    <message>
        <source>Bits in &amp;rows of 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bar over the &amp;position range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Decimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Binary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers of the &amp;whole word, not of D24..D0</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::InlineMessage</name>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>role: sentence</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::JsonObject</name>
    <message>
        <source>An object { } is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key is not known. Known are: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here. Known are: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A text in quotation marks is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole number is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hexadecimal number such as &quot;37h&quot; is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A list [ ] is expected here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::MonitorArea</name>
    <message>
        <source>No monitor is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A monitor shows one word of one device, and lets you set the bits of an OUT word. Use Add monitor, or the menu of a device in the bus structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another word of a device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device on the bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no word %2 to show. Choose another device or word.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::NumberFields</name>
    <message>
        <source>Hexadecimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hexadecimal</source>
        <comment>OUT 1.0 hexadecimal</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 decimal</source>
        <comment>OUT 1.0 decimal</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 signed</source>
        <comment>OUT 1.0 signed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Gray</source>
        <comment>OUT 1.0 Gray</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Binary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 binary</source>
        <comment>OUT 1.0 binary</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the word: 020000FF, 0x020000FF, 20000FFh; spaces are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0 as a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole word as a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D24..D0 as a signed number (two&apos;s complement)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole word as a signed number (two&apos;s complement)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number that D24..D0 give when read as Gray code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number that the whole word gives when read as Gray code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All bits, the highest first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::SequenceModel</name>
    <message>
        <source>Word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::SequenceView</name>
    <message>
        <source>&amp;Send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unacknowledged words for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No encoder is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sequence is a list of words that are sent to an encoder one after the other. Select an encoder in the bus structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words to send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>what it does, key</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a word below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the word up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the word down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert the column of words that was copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a sequence from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this sequence in a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> cycles</source>
        <comment>unit of a number of bus cycles</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycles for words that nothing acknowledges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long a word stands that nothing acknowledges; others stand until they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send the sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the sequence, and choose what becomes of the encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run: end the parameterization with what the encoder has taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave the encoder as it is, OUT back to 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sequence.json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not read. %2</source>
        <comment>file, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>All %n words were sent.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Sent before that: %2 of %3 words.</source>
        <comment>reason, counts</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add or paste words to send.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n words to %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Send the words to %1 one after the other, each until it is acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::StructureModel</name>
    <message>
        <source>device not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>READY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RUN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BUS FAIL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not seen yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>job running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OUT not sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ok</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ID code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words IN / OUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Master</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The master of the ring is in the state %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2
ID code %3, device code %4
%5 words IN, %6 words OUT
State: %7</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::StructureView</name>
    <message>
        <source>No ring is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The training bus starts with the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bus structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a device to see it in the panels. Enter opens its monitors.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::TraceModel</name>
    <message>
        <source>Date and time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since last, ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remark</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::TraceView</name>
    <message>
        <source>No encoder is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handshake trace has a row for each change of the words of an encoder. Select an encoder in the bus structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>what it does, key</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the newest row in view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the table; rows that come are kept and shown afterwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with tabs between the columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all rows as a CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all rows of this encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n rows</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paused, %n new</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 oldest dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trace.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <comment>file, reason</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::WordMonitor</name>
    <message>
        <source>Monitor %1</source>
        <comment>Monitor OUT 1.0</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 half</source>
        <comment>IN 1.0 half</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which half of the 32 bits is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show of %1</source>
        <comment>Show of OUT 1.0</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose what this kind of monitor shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close monitor %1</source>
        <comment>Close monitor OUT 1.0</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as hexadecimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as two words of a PLC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not explained: there is no description of this device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent yet: %1</source>
        <comment>meaning of a word</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has a command bit or a parameter number, so it is not sent at once. Send it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send %1</source>
        <comment>a word</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::WordSender</name>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write %1</source>
        <comment>Write OUT 1.0</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send this word to the encoder; it stands there until another is sent (Ctrl+Return)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard %1</source>
        <comment>Discard OUT 1.0</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the word that stands on the bus (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send %1 at once</source>
        <comment>Send OUT 1.0 at once</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send each change as it is made. Words with a parameter number or a command bit (D31..D25) still ask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>codewheel::WordView</name>
    <message>
        <source>%1 bits</source>
        <comment>OUT 1.0 bits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bit %2</source>
        <comment>OUT 1.0 bit 25</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not sent yet)</source>
        <comment>meaning of a bit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>bit: meaning</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
