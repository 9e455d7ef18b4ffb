<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AgeText</name>
    <message>
        <source>%1 Shown is how it was %2.</source>
        <comment>reason, 20 s ago</comment>
        <translation>%1 Stand: %2.</translation>
    </message>
    <message>
        <source>%1 Shown is how it was on %2.</source>
        <comment>reason, date and time</comment>
        <translation>%1 Gezeigt ist der Stand vom %2.</translation>
    </message>
    <message>
        <source>It has shown the same since %1.</source>
        <comment>14:02</comment>
        <translation>Es zeigt dasselbe seit %1.</translation>
    </message>
</context>
<context>
    <name>BitText</name>
    <message>
        <source>D31: start (run), when it changes from 0 to 1</source>
        <translation>D31: Start (Run), beim Wechsel von 0 auf 1</translation>
    </message>
    <message>
        <source>D30: initialise the preset; in cam mode: start or stop of a cam</source>
        <translation>D30: Preset initialisieren; im Nockenbetrieb: Anfang oder Ende eines Nockens</translation>
    </message>
    <message>
        <source>D30: initialise the preset</source>
        <translation>D30: Preset initialisieren</translation>
    </message>
    <message>
        <source>D29: FRABA command</source>
        <translation>D29: FRABA-Befehl</translation>
    </message>
    <message>
        <source>D29: ignored by this encoder</source>
        <translation>D29: von diesem Geber nicht beachtet</translation>
    </message>
    <message>
        <source>D29: manufacturer specific</source>
        <translation>D29: herstellerspezifisch</translation>
    </message>
    <message>
        <source>D28..D25: parameter number; in cam mode: number of the cam</source>
        <translation>D28..D25: Parameternummer; im Nockenbetrieb: Nummer des Nockens</translation>
    </message>
    <message>
        <source>D28..D25: parameter number</source>
        <translation>D28..D25: Parameternummer</translation>
    </message>
    <message>
        <source>D24..D0: parameter data; D16 with D29 and D21: read out as long as it is 1</source>
        <translation>D24..D0: Parameterdaten; D16 mit D29 und D21: Auslesen, solange es 1 ist</translation>
    </message>
    <message>
        <source>D24..D0: parameter data</source>
        <translation>D24..D0: Parameterdaten</translation>
    </message>
    <message>
        <source>D31: position not valid</source>
        <translation>D31: Position nicht gültig</translation>
    </message>
    <message>
        <source>D30: parameterization</source>
        <translation>D30: Parametrierung</translation>
    </message>
    <message>
        <source>D29: with D31: read-out value or self test</source>
        <translation>D29: mit D31: Auslesewert oder Selbsttest</translation>
    </message>
    <message>
        <source>D29: means nothing at this encoder</source>
        <translation>D29: bei diesem Geber ohne Bedeutung</translation>
    </message>
    <message>
        <source>D28..D25: parameter number, or error number</source>
        <translation>D28..D25: Parameternummer oder Fehlernummer</translation>
    </message>
    <message>
        <source>D24..D0: position, confirmed data or read-out value</source>
        <translation>D24..D0: Position, quittierte Daten oder Auslesewert</translation>
    </message>
    <message>
        <source>D24..D0: position or confirmed data</source>
        <translation>D24..D0: Position oder quittierte Daten</translation>
    </message>
    <message>
        <source>D31: service bit, asks when it changes from 0 to 1</source>
        <translation>D31: Dienst-Bit, Anforderung beim Wechsel von 0 auf 1</translation>
    </message>
    <message>
        <source>D31: service bit, acknowledges</source>
        <translation>D31: Dienst-Bit, Quittung</translation>
    </message>
    <message>
        <source>D30: 0 read, 1 write</source>
        <translation>D30: 0 lesen, 1 schreiben</translation>
    </message>
    <message>
        <source>D29: always 0</source>
        <translation>D29: immer 0</translation>
    </message>
    <message>
        <source>D29: error</source>
        <translation>D29: Fehler</translation>
    </message>
    <message>
        <source>D28: always 0</source>
        <translation>D28: immer 0</translation>
    </message>
    <message>
        <source>D27..D24: service number</source>
        <translation>D27..D24: Nummer des Dienstes</translation>
    </message>
    <message>
        <source>D23..D0: data to write</source>
        <translation>D23..D0: zu schreibende Daten</translation>
    </message>
    <message>
        <source>D23..D0: position; in service mode data written or read</source>
        <translation>D23..D0: Position; im Dienstbetrieb geschriebene oder gelesene Daten</translation>
    </message>
    <message>
        <source>D31..D0: no source describes them</source>
        <translation>D31..D0: in keiner Quelle beschrieben</translation>
    </message>
    <message>
        <source>D%1: this encoder has no OUT word</source>
        <translation>D%1: Dieser Geber hat kein OUT-Wort</translation>
    </message>
    <message>
        <source>D%1: not used, always 0</source>
        <translation>D%1: unbenutzt, immer 0</translation>
    </message>
    <message>
        <source>D31..D0: position; no source says which four bits are status bits</source>
        <translation>D31..D0: Position; welche vier Bits Statusbits sind, steht in keiner Quelle</translation>
    </message>
    <message>
        <source>D%1..D0: position</source>
        <translation>D%1..D0: Position</translation>
    </message>
</context>
<context>
    <name>BusFault</name>
    <message>
        <source>peripheral fault</source>
        <translation>Peripheriefehler</translation>
    </message>
    <message>
        <source>the master is looking for the fault</source>
        <translation>der Master sucht den Fehler</translation>
    </message>
    <message>
        <source>the bus failed, but the check finds nothing: look at shielding, connectors and supply</source>
        <translation>der Bus ist ausgefallen, aber die Prüfung findet nichts: Schirmung, Stecker und Versorgung ansehen</translation>
    </message>
    <message>
        <source>outgoing remote bus of %1</source>
        <translation>abgehender Fernbus von %1</translation>
    </message>
    <message>
        <source>outgoing local bus of %1</source>
        <translation>abgehender Lokalbus von %1</translation>
    </message>
    <message>
        <source>%1 at %2 (see IBS SYS FW G4 UM)</source>
        <translation>%1, Ort: %2 (siehe IBS SYS FW G4 UM)</translation>
    </message>
    <message>
        <source>%1 (see IBS SYS FW G4 UM)</source>
        <translation>%1 (siehe IBS SYS FW G4 UM)</translation>
    </message>
    <message>
        <source>%1 – %2 at %3</source>
        <translation>%1 – %2, Ort: %3</translation>
    </message>
</context>
<context>
    <name>CamTexts</name>
    <message>
        <source>What the encoder has is not known.</source>
        <translation>Der Stand im Geber ist unbekannt.</translation>
    </message>
    <message>
        <source>The encoder has the same.</source>
        <translation>Im Geber steht dasselbe.</translation>
    </message>
    <message>
        <source>The encoder has %1, %2.</source>
        <comment>21 to 531, active</comment>
        <translation>Im Geber steht %1, %2.</translation>
    </message>
    <message>
        <source>Cam %1</source>
        <translation>Nocken %1</translation>
    </message>
    <message>
        <source>%1 to %2, through zero</source>
        <translation>%1 bis %2, über null</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>inactive</source>
        <translation>nicht aktiv</translation>
    </message>
    <message>
        <source>Move cam %1</source>
        <translation>Nocken %1 verschieben</translation>
    </message>
    <message>
        <source>Start of cam %1</source>
        <translation>Anfang von Nocken %1</translation>
    </message>
    <message>
        <source>Stop of cam %1</source>
        <translation>Ende von Nocken %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>would be on</source>
        <translation>wäre ein</translation>
    </message>
    <message>
        <source>would be off</source>
        <translation>wäre aus</translation>
    </message>
    <message>
        <source>%1 is not set.</source>
        <translation>%1 ist nicht gesetzt.</translation>
    </message>
    <message>
        <source>%1: %2, %3.</source>
        <comment>Cam 3: 21 to 531, active</comment>
        <translation>%1: %2; %3.</translation>
    </message>
    <message>
        <source>Now: %1.</source>
        <translation>Jetzt: %1.</translation>
    </message>
    <message>
        <source>Hysteresis: %1.</source>
        <translation>Hysterese: %1.</translation>
    </message>
    <message>
        <source>It is on outside of these positions.</source>
        <translation>Außerhalb dieser Positionen ist er ein.</translation>
    </message>
    <message>
        <source>The encoder had the same.</source>
        <translation>Im Geber stand dasselbe.</translation>
    </message>
    <message>
        <source>The encoder had %1, %2.</source>
        <comment>21 to 531, active</comment>
        <translation>Im Geber stand %1, %2.</translation>
    </message>
</context>
<context>
    <name>CheckProject</name>
    <message>
        <source>%1 at %2 overlaps that of %3.</source>
        <translation>%1 bei %2 überschneidet sich mit %3.</translation>
    </message>
    <message>
        <source>%1 begins at the odd byte %2, within a word.</source>
        <translation>%1 beginnt bei dem ungeraden Byte %2, mitten in einem Wort.</translation>
    </message>
    <message>
        <source>%1 is not above P127: with Step 5, the process image overwrites it.</source>
        <translation>%1 liegt nicht über P127: Bei Step 5 überschreibt das Prozessabbild diesen Bereich.</translation>
    </message>
    <message>
        <source>Devices with this ID code belong on the local bus of a bus terminal.</source>
        <translation>Geräte mit diesem ID-Code gehören an den Lokalbus einer Busklemme.</translation>
    </message>
</context>
<context>
    <name>Choice</name>
    <message>
        <source>CW</source>
        <translation>CW</translation>
    </message>
    <message>
        <source>CCW</source>
        <translation>CCW</translation>
    </message>
    <message>
        <source>signed, CW</source>
        <translation>mit Vorzeichen, CW</translation>
    </message>
    <message>
        <source>signed, CCW</source>
        <translation>mit Vorzeichen, CCW</translation>
    </message>
    <message>
        <source>unsigned, CW</source>
        <translation>ohne Vorzeichen, CW</translation>
    </message>
    <message>
        <source>unsigned, CCW</source>
        <translation>ohne Vorzeichen, CCW</translation>
    </message>
    <message>
        <source>Gray, CW</source>
        <translation>Gray, CW</translation>
    </message>
    <message>
        <source>Gray, CCW</source>
        <translation>Gray, CCW</translation>
    </message>
    <message>
        <source>preset activated</source>
        <translation>Preset aktiv</translation>
    </message>
    <message>
        <source>preset programmed, not activated</source>
        <translation>Preset programmiert, nicht aktiv</translation>
    </message>
    <message>
        <source>position, as K2</source>
        <translation>Position, als K2</translation>
    </message>
    <message>
        <source>position, as K3</source>
        <translation>Position, als K3</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>single-turn</source>
        <translation>Singleturn</translation>
    </message>
    <message>
        <source>single-turn, steps minus 1</source>
        <translation>Singleturn, Schritte minus 1</translation>
    </message>
    <message>
        <source>multi-turn</source>
        <translation>Multiturn</translation>
    </message>
    <message>
        <source>multi-turn, steps minus 1</source>
        <translation>Multiturn, Schritte minus 1</translation>
    </message>
    <message>
        <source>cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>magnet outside the measuring range</source>
        <translation>Magnet außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>DeviceDescription</name>
    <message>
        <source>%1, make not known</source>
        <translation>%1, Hersteller unbekannt</translation>
    </message>
    <message>
        <source>en</source>
        <comment>code of the language of these texts</comment>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>DeviceError</name>
    <message>
        <source>wrong parameter data</source>
        <translation>falsche Parameterdaten</translation>
    </message>
    <message>
        <source>unknown parameter number</source>
        <translation>unbekannte Parameternummer</translation>
    </message>
    <message>
        <source>parameters lost</source>
        <translation>Parameter verloren</translation>
    </message>
    <message>
        <source>parameters could not be stored</source>
        <translation>Parameter nicht speicherbar</translation>
    </message>
    <message>
        <source>battery low</source>
        <translation>Batterie schwach</translation>
    </message>
    <message>
        <source>faulty value of the code disc</source>
        <translation>fehlerhafter Wert der Codescheibe</translation>
    </message>
    <message>
        <source>an error of the manufacturer&apos;s own</source>
        <translation>ein herstellereigener Fehler</translation>
    </message>
    <message>
        <source>no valid position</source>
        <translation>keine gültige Position</translation>
    </message>
    <message>
        <source>not defined for this encoder</source>
        <translation>für diesen Geber nicht definiert</translation>
    </message>
    <message>
        <source>magnet outside the measuring range</source>
        <translation>Magnet außerhalb des Messbereichs</translation>
    </message>
</context>
<context>
    <name>DialNote</name>
    <message>
        <source>The encoder has no valid position.</source>
        <translation>Der Geber hat keine gültige Position.</translation>
    </message>
    <message>
        <source>The encoder shows error %1: there is no position.</source>
        <translation>Der Geber meldet Fehler %1: keine Position.</translation>
    </message>
    <message>
        <source>In parameterization: there is no position.</source>
        <translation>In der Parametrierung: keine Position.</translation>
    </message>
    <message>
        <source>In service mode: there is no position.</source>
        <translation>Im Dienstbetrieb: keine Position.</translation>
    </message>
    <message>
        <source>No manual describes IN %1: there is no position.</source>
        <translation>IN %1 steht in keinem Handbuch: keine Position.</translation>
    </message>
    <message>
        <source>The encoder does not answer: the last position is shown.</source>
        <translation>Der Geber antwortet nicht: Gezeigt wird die letzte Position.</translation>
    </message>
    <message>
        <source>Not up to date: %1</source>
        <comment>a sentence</comment>
        <translation>Nicht aktuell: %1</translation>
    </message>
    <message>
        <source>The encoder does not answer: no position is known.</source>
        <translation>Der Geber antwortet nicht: Es ist keine Position bekannt.</translation>
    </message>
    <message>
        <source>No position while the encoder sends its velocity.</source>
        <translation>Keine Position, solange der Geber seine Drehzahl sendet.</translation>
    </message>
    <message>
        <source>Raw word %1. The make of the encoder is not known, and so neither is its coding: name it in the bus structure.</source>
        <translation>Rohwort %1. Der Hersteller des Gebers ist unbekannt und damit auch die Codierung: Den Geber im Busaufbau benennen.</translation>
    </message>
    <message>
        <source>Raw word %1. The coding is not known: write it, or set it manually under Parameters.</source>
        <translation>Rohwort %1. Codierung unbekannt: Unter Parameter schreiben oder eintragen.</translation>
    </message>
    <message>
        <source>Raw word %1, in cam mode: there is no position.</source>
        <translation>Rohwort %1, im Nockenbetrieb: keine Position.</translation>
    </message>
    <message>
        <source>Raw word %1. The mode is not known: set the start-up mode manually under Parameters.</source>
        <translation>Rohwort %1. Betriebsart unbekannt: Die Anlaufbetriebsart unter Parameter eintragen.</translation>
    </message>
    <message>
        <source>IN holds a read-out value: there is no position.</source>
        <translation>In IN steht ein Auslesewert: keine Position.</translation>
    </message>
    <message>
        <source>No word of the encoder is known.</source>
        <translation>Kein Wort des Gebers ist bekannt.</translation>
    </message>
</context>
<context>
    <name>EncoderState</name>
    <message>
        <source>The encoder waits for its parameters or to be started, and gives no position.</source>
        <translation>Der Geber wartet auf seine Parameter oder darauf, gestartet zu werden, und liefert keine Position.</translation>
    </message>
</context>
<context>
    <name>EscBit</name>
    <message>
        <source>direction CCW</source>
        <translation>Zählrichtung CCW</translation>
    </message>
    <message>
        <source>direction CW</source>
        <translation>Zählrichtung CW</translation>
    </message>
    <message>
        <source>diagnostic active</source>
        <translation>Diagnose aktiv</translation>
    </message>
    <message>
        <source>scaling on</source>
        <translation>Skalierung ein</translation>
    </message>
    <message>
        <source>scaling off</source>
        <translation>Skalierung aus</translation>
    </message>
    <message>
        <source>calculated factor</source>
        <translation>berechneter Faktor</translation>
    </message>
    <message>
        <source>resolution per revolution</source>
        <translation>Auflösung je Umdrehung</translation>
    </message>
    <message>
        <source>total measuring range</source>
        <translation>gesamter Messbereich</translation>
    </message>
    <message>
        <source>limit switch active</source>
        <translation>Endschalter aktiv</translation>
    </message>
    <message>
        <source>position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>general fault</source>
        <translation>allgemeiner Fehler</translation>
    </message>
    <message>
        <source>battery flat</source>
        <translation>Batterie leer</translation>
    </message>
    <message>
        <source>temperature exceeded</source>
        <translation>Temperatur überschritten</translation>
    </message>
    <message>
        <source>frequency exceeded</source>
        <translation>Frequenz überschritten</translation>
    </message>
    <message>
        <source>light control</source>
        <translation>Lichtregelung</translation>
    </message>
    <message>
        <source>battery limit reached</source>
        <translation>Batteriegrenze erreicht</translation>
    </message>
    <message>
        <source>reference point reached</source>
        <translation>Referenzpunkt erreicht</translation>
    </message>
    <message>
        <source>turning CCW</source>
        <translation>dreht CCW</translation>
    </message>
    <message>
        <source>lower limit switch on</source>
        <translation>unterer Endschalter ein</translation>
    </message>
    <message>
        <source>upper limit switch on</source>
        <translation>oberer Endschalter ein</translation>
    </message>
    <message>
        <source>position warning</source>
        <translation>Positionswarnung</translation>
    </message>
    <message>
        <source>standstill</source>
        <translation>Stillstand</translation>
    </message>
    <message>
        <source>bit %1 (not described)</source>
        <translation>Bit %1 (nicht beschrieben)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>EscCommand</name>
    <message>
        <source>operating parameters</source>
        <translation>Betriebsparameter</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>total measuring range</source>
        <translation>gesamter Messbereich</translation>
    </message>
    <message>
        <source>steps per revolution</source>
        <translation>Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>operating time</source>
        <translation>Betriebszeit</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Offset</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>upper limit switch</source>
        <translation>oberer Endschalter</translation>
    </message>
    <message>
        <source>lower limit switch</source>
        <translation>unterer Endschalter</translation>
    </message>
    <message>
        <source>scaling factor</source>
        <translation>Skalierungsfaktor</translation>
    </message>
    <message>
        <source>device code</source>
        <translation>Gerätecode</translation>
    </message>
    <message>
        <source>number of revolutions</source>
        <translation>Anzahl der Umdrehungen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Zählrichtung</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>device address</source>
        <translation>Geräteadresse</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>Baudrate</translation>
    </message>
</context>
<context>
    <name>EscExplain</name>
    <message>
        <source>00 (any encoder)</source>
        <translation>00 (jeder Geber)</translation>
    </message>
    <message>
        <source>%1, bytes swapped %2</source>
        <translation>%1, Bytes vertauscht %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>CCW</source>
        <translation>CCW</translation>
    </message>
    <message>
        <source>CW</source>
        <translation>CW</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>%1, outside %2 to %3</source>
        <translation>%1, außerhalb von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 = %2 h</source>
        <translation>%1 = %2 h</translation>
    </message>
    <message>
        <source>%1: %2?</source>
        <translation>%1: %2?</translation>
    </message>
    <message>
        <source>%1: set %2 to %3</source>
        <translation>%1: %2 auf %3 setzen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>command unknown (03)</source>
        <translation>Befehl unbekannt (03)</translation>
    </message>
    <message>
        <source>incomplete or out of range (05)</source>
        <translation>unvollständig oder außerhalb des Bereichs (05)</translation>
    </message>
</context>
<context>
    <name>EscLineRate</name>
    <message>
        <source>%1 (at %2 Bd)</source>
        <translation>%1 (mit %2 Bd)</translation>
    </message>
    <message>
        <source>Connected again at %1 Bd these encoders will not answer: %2.</source>
        <translation>Nach dem Neuverbinden mit %1 Bd antworten diese Geber nicht: %2.</translation>
    </message>
    <message>
        <source>Give all encoders of the line the same baud rate.</source>
        <translation>Alle Geber der Leitung auf dieselbe Baudrate einstellen.</translation>
    </message>
</context>
<context>
    <name>EscLineRecordFile</name>
    <message>
        <source>This is not a session of a serial line: &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>Das ist keine Aufzeichnung einer seriellen Leitung: „format“ ist nicht „%1“.</translation>
    </message>
    <message>
        <source>Only version %1 of the format can be read.</source>
        <translation>Nur Version %1 des Formats lässt sich lesen.</translation>
    </message>
    <message>
        <source>A date and time is expected here, as in 2026-11-21T12:00:00.000+01:00.</source>
        <translation>Hier werden Datum und Uhrzeit erwartet, etwa 2026-11-21T12:00:00.000+01:00.</translation>
    </message>
    <message>
        <source>Bytes are expected here, as in &quot;1B 30 35 50 0D 0A&quot;.</source>
        <translation>Hier werden Bytes erwartet, etwa &quot;1B 30 35 50 0D 0A&quot;.</translation>
    </message>
    <message>
        <source>A row has %1 bytes at most.</source>
        <translation>Eine Zeile hat höchstens %1 Bytes.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2, %3: %4</source>
        <translation>%1, Zeile %2, %3: %4</translation>
    </message>
</context>
<context>
    <name>EscLineRecordFiles</name>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht gespeichert: %2</translation>
    </message>
</context>
<context>
    <name>EscLineRowText</name>
    <message>
        <source>no request of this protocol</source>
        <translation>keine Anfrage dieses Protokolls</translation>
    </message>
    <message>
        <source>no well-formed answer</source>
        <translation>keine gültige Antwort</translation>
    </message>
    <message>
        <source>what was sent, echoed by the adapter: dropped</source>
        <translation>vom Adapter zurückgegebenes Gesendetes: verworfen</translation>
    </message>
    <message>
        <source>no well-formed answer to &quot;%1&quot;: dropped</source>
        <translation>keine gültige Antwort auf „%1“: verworfen</translation>
    </message>
    <message>
        <source>nobody asked for it: dropped</source>
        <translation>ohne Anfrage eingegangen: verworfen</translation>
    </message>
    <message>
        <source>came after its time-out: dropped</source>
        <translation>nach der Zeitüberschreitung eingegangen: verworfen</translation>
    </message>
</context>
<context>
    <name>EscPlan</name>
    <message>
        <source>%1, which goes with a measuring range of %2</source>
        <translation>%1, passend zu einem Messbereich von %2</translation>
    </message>
</context>
<context>
    <name>Freshness</name>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>vor %1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min ago</source>
        <translation>vor %1 h %2 min</translation>
    </message>
    <message>
        <source>Nothing has come from the encoder yet.</source>
        <translation>Vom Geber kam noch nichts.</translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation>Nicht verbunden.</translation>
    </message>
    <message>
        <source>The link is lost.</source>
        <translation>Die Verbindung ist unterbrochen.</translation>
    </message>
    <message>
        <source>The bus does not run.</source>
        <translation>Der Bus läuft nicht.</translation>
    </message>
    <message>
        <source>The encoder does not answer.</source>
        <translation>Der Geber antwortet nicht.</translation>
    </message>
    <message>
        <source>The encoder is not being asked: something else keeps the line busy.</source>
        <translation>Der Geber wird gerade nicht gefragt: Die Leitung ist anderweitig belegt.</translation>
    </message>
    <message>
        <source>The computer has slept since.</source>
        <translation>Der Rechner war inzwischen im Ruhezustand.</translation>
    </message>
    <message>
        <source>The device is not on the bus.</source>
        <translation>Das Gerät ist nicht am Bus.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung weg</translation>
    </message>
    <message>
        <source>Bus stopped</source>
        <translation>Bus angehalten</translation>
    </message>
    <message>
        <source>Not on the bus</source>
        <translation>Nicht am Bus</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Not asked</source>
        <translation>Nicht gefragt</translation>
    </message>
    <message>
        <source>Computer slept</source>
        <translation>Rechner war im Ruhezustand</translation>
    </message>
    <message>
        <source>%1 Last seen: %2.</source>
        <comment>a sentence, date and time</comment>
        <translation>%1 Zuletzt gesehen: %2.</translation>
    </message>
    <message>
        <source>This is a recording.</source>
        <translation>Dies ist eine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Of this time nothing is recorded.</source>
        <translation>Aus dieser Zeit ist nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>No two reads of its word agree.</source>
        <translation>Keine zwei Lesungen seines Wortes stimmen überein.</translation>
    </message>
    <message>
        <source>Unsettled</source>
        <comment>its word</comment>
        <translation>Unstimmig</translation>
    </message>
</context>
<context>
    <name>IdCode</name>
    <message>
        <source>digital output</source>
        <translation>Digitalausgang</translation>
    </message>
    <message>
        <source>digital input</source>
        <translation>Digitaleingang</translation>
    </message>
    <message>
        <source>digital input and output</source>
        <translation>Digitalein- und -ausgang</translation>
    </message>
    <message>
        <source>bus terminal</source>
        <translation>Busklemme</translation>
    </message>
    <message>
        <source>analog output</source>
        <translation>Analogausgang</translation>
    </message>
    <message>
        <source>analog input</source>
        <translation>Analogeingang</translation>
    </message>
    <message>
        <source>analog input and output</source>
        <translation>Analogein- und -ausgang</translation>
    </message>
    <message>
        <source>encoder K1 or K2</source>
        <translation>Geber K1 oder K2</translation>
    </message>
    <message>
        <source>encoder K3</source>
        <translation>Geber K3</translation>
    </message>
    <message>
        <source>encoder K1 or K2, Loop 2</source>
        <translation>Geber K1 oder K2, Loop 2</translation>
    </message>
    <message>
        <source>encoder K3, Loop 2</source>
        <translation>Geber K3, Loop 2</translation>
    </message>
    <message>
        <source>Inline digital input</source>
        <translation>Inline-Digitaleingang</translation>
    </message>
    <message>
        <source>drive with PCP</source>
        <translation>Antrieb mit PCP</translation>
    </message>
    <message>
        <source>encoder K4</source>
        <translation>Geber K4</translation>
    </message>
</context>
<context>
    <name>JobReport</name>
    <message>
        <source>cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>factory settings</source>
        <translation>Werkseinstellungen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
</context>
<context>
    <name>JournalFiles</name>
    <message>
        <source>Messages are not kept, and EEPROM writes are counted for this connection only: Qt&apos;s driver for SQLite is missing on this computer. Install the package libqt6sql6-sqlite.</source>
        <translation>Meldungen werden nicht aufbewahrt, und EEPROM-Schreibvorgänge werden nur für diese Verbindung gezählt: Auf diesem Rechner fehlt der Qt-Treiber für SQLite. Das Paket libqt6sql6-sqlite installieren.</translation>
    </message>
</context>
<context>
    <name>KnownText</name>
    <message>
        <source>The encoder is in operation.</source>
        <translation>Der Geber ist in Betrieb.</translation>
    </message>
    <message>
        <source>The encoder is in parameterization: it gives no position until run is sent.</source>
        <translation>Der Geber ist in der Parametrierung: keine Position, bis Run gesendet wird.</translation>
    </message>
    <message>
        <source>The encoder still shows a read-out value.</source>
        <translation>Der Geber zeigt noch einen Auslesewert.</translation>
    </message>
    <message>
        <source>The encoder has not been seen on the bus.</source>
        <translation>Der Geber war noch nicht am Bus zu sehen.</translation>
    </message>
    <message>
        <source>The state of the encoder is not known.</source>
        <translation>Der Zustand des Gebers ist unbekannt.</translation>
    </message>
    <message>
        <source>The encoder is in service mode: it gives no position until the service bit is 0.</source>
        <translation>Der Geber ist im Dienstbetrieb: Er gibt keine Position aus, bis das Dienst-Bit 0 ist.</translation>
    </message>
    <message>
        <source>The encoder is in the error state: it gives no valid position.</source>
        <translation>Der Geber ist im Fehlerzustand: Er gibt keine gültige Position aus.</translation>
    </message>
    <message>
        <source>The encoder does not answer any more.</source>
        <translation>Der Geber antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>It has its earlier values again: they were read back and match.</source>
        <translation>Er hat wieder die vorigen Werte: Sie wurden zurückgelesen und stimmen überein.</translation>
    </message>
    <message>
        <source>It has confirmed its earlier values and runs with them; it cannot be read.</source>
        <translation>Er hat die vorigen Werte quittiert und läuft damit; auslesen lässt er sich nicht.</translation>
    </message>
    <message>
        <source>Which position it shows now is not known.</source>
        <translation>Welche Position er jetzt zeigt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It shows %1 now.</source>
        <translation>Er zeigt jetzt %1.</translation>
    </message>
    <message>
        <source>The encoder moves: the place that gets the new position is where it stands when the command arrives.</source>
        <translation>Der Geber dreht sich: Die neue Position bekommt die Stelle, an der er steht, wenn der Befehl ankommt.</translation>
    </message>
    <message>
        <source>The position was set before, and stays so.</source>
        <translation>Die Position war schon gesetzt und bleibt es.</translation>
    </message>
    <message>
        <source>The position went from %1 to %2.</source>
        <translation>Die Position ging von %1 auf %2.</translation>
    </message>
    <message>
        <source>The position is %1.</source>
        <translation>Die Position ist %1.</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <comment>names and values</comment>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message>
        <source>Valid now: %1.</source>
        <comment>names and values</comment>
        <translation>Jetzt gilt: %1.</translation>
    </message>
    <message>
        <source>As long as it is not known whether the encoder counts steps minus 1, a word written by hand does not tell its steps.</source>
        <translation>Solange nicht bekannt ist, ob der Geber Schritte minus 1 zählt, sagt ein von Hand geschriebenes Wort nicht, welche Schritte er hat.</translation>
    </message>
</context>
<context>
    <name>Leds</name>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>blinking</source>
        <translation>blinkt</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>Master</name>
    <message>
        <source>A user error: a service was called wrongly.</source>
        <translation>Anwenderfehler: Ein Dienst wurde falsch aufgerufen.</translation>
    </message>
    <message>
        <source>A device reports a peripheral fault, until it is confirmed.</source>
        <translation>Ein Teilnehmer meldet einen Peripheriefehler, bis er quittiert wird.</translation>
    </message>
    <message>
        <source>The bus has failed: no data cycles run.</source>
        <translation>Der Bus ist ausgefallen: Es laufen keine Datenzyklen.</translation>
    </message>
    <message>
        <source>The master itself is faulty.</source>
        <translation>Der Master selbst ist gestört.</translation>
    </message>
    <message>
        <source>The master is looking for the place of a fault.</source>
        <translation>Der Master sucht den Ort eines Fehlers.</translation>
    </message>
    <message>
        <source>Data cycles run.</source>
        <translation>Datenzyklen laufen.</translation>
    </message>
    <message>
        <source>A configuration is active.</source>
        <translation>Eine Konfiguration ist aktiv.</translation>
    </message>
    <message>
        <source>The master is ready for services.</source>
        <translation>Der Master ist bereit für Dienste.</translation>
    </message>
    <message>
        <source>A segment is switched off.</source>
        <translation>Ein Segment ist abgeschaltet.</translation>
    </message>
    <message>
        <source>The controller above the master has failed.</source>
        <translation>Die Steuerung über dem Master ist ausgefallen.</translation>
    </message>
    <message>
        <source>A service ended with a negative result.</source>
        <translation>Ein Dienst endete mit negativem Ergebnis.</translation>
    </message>
    <message>
        <source>Synchronizing ended with a negative result.</source>
        <translation>Das Synchronisieren endete mit negativem Ergebnis.</translation>
    </message>
    <message>
        <source>A data cycle was faulty.</source>
        <translation>Ein Datenzyklus war fehlerhaft.</translation>
    </message>
    <message>
        <source>A time that was waited for has passed.</source>
        <translation>Eine überwachte Zeit ist abgelaufen.</translation>
    </message>
    <message>
        <source>Too many data cycles are faulty.</source>
        <translation>Zu viele Datenzyklen sind fehlerhaft.</translation>
    </message>
    <message>
        <source>A message waits in the master.</source>
        <translation>Im Master wartet eine Meldung.</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>ACTIVE</translation>
    </message>
    <message>
        <source>RUN</source>
        <translation>RUN</translation>
    </message>
    <message>
        <source>BUS FAIL</source>
        <translation>BUS FAIL</translation>
    </message>
    <message>
        <source>READY</source>
        <translation>READY</translation>
    </message>
    <message>
        <source>reading the configuration (030B)</source>
        <translation>Konfiguration lesen (030B)</translation>
    </message>
    <message>
        <source>starting data transfer (0701)</source>
        <translation>Datenübertragung starten (0701)</translation>
    </message>
    <message>
        <source>stopping data transfer (0702)</source>
        <translation>Datenübertragung anhalten (0702)</translation>
    </message>
    <message>
        <source>reading in the ring (0710)</source>
        <translation>Ring einlesen (0710)</translation>
    </message>
    <message>
        <source>activating the configuration (0711)</source>
        <translation>Konfiguration aktivieren (0711)</translation>
    </message>
    <message>
        <source>deactivating the configuration (0712)</source>
        <translation>Konfiguration deaktivieren (0712)</translation>
    </message>
    <message>
        <source>switching a segment (0713)</source>
        <translation>Segment schalten (0713)</translation>
    </message>
    <message>
        <source>confirming the diagnostics (0760)</source>
        <translation>Diagnose quittieren (0760)</translation>
    </message>
    <message>
        <source>alarm stop (1303)</source>
        <translation>ALARM-STOPP (1303)</translation>
    </message>
    <message>
        <source>downloading the configuration</source>
        <translation>Konfiguration laden</translation>
    </message>
    <message>
        <source>not looked for in READY</source>
        <translation>in READY nicht gesucht</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
</context>
<context>
    <name>Meaning</name>
    <message>
        <source>, or: </source>
        <translation>, oder: </translation>
    </message>
    <message>
        <source>Running, %1</source>
        <translation>In Betrieb, %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 (there are only %2 to %3)</source>
        <translation>%1 (es gibt nur %2 bis %3)</translation>
    </message>
    <message>
        <source>%1: cam start or stop above the largest position</source>
        <translation>%1: Anfang oder Ende eines Nockens über der größten Position</translation>
    </message>
    <message>
        <source>Parameter %1</source>
        <translation>Parameter %1</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>Parameter %1</translation>
    </message>
    <message>
        <source>Parameter %1 %2</source>
        <translation>Parameter %1 %2</translation>
    </message>
    <message>
        <source>parameter %1 %2</source>
        <translation>Parameter %1 %2</translation>
    </message>
    <message>
        <source>code %1, which is not defined</source>
        <translation>Code %1, nicht definiert</translation>
    </message>
    <message>
        <source>Normal running</source>
        <translation>Normalbetrieb</translation>
    </message>
    <message>
        <source>Normal running; the data %1 mean nothing</source>
        <translation>Normalbetrieb; die Daten %1 sind ohne Bedeutung</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Run (Start)</translation>
    </message>
    <message>
        <source>Run; the other bits (%1) are ignored</source>
        <translation>Run (Start); die übrigen Bits (%1) zählen nicht</translation>
    </message>
    <message>
        <source>Initialise the preset</source>
        <translation>Preset initialisieren</translation>
    </message>
    <message>
        <source>FRABA preset: activate the preset in every cycle</source>
        <translation>FRABA-Preset: Preset in jedem Zyklus aktivieren</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>%1 = %2: refused in cam mode</source>
        <translation>%1 = %2: im Nockenbetrieb abgelehnt</translation>
    </message>
    <message>
        <source>Reset to factory settings</source>
        <translation>Auf Werkseinstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>Velocity mode on</source>
        <translation>Drehzahlbetrieb ein</translation>
    </message>
    <message>
        <source>Velocity mode off</source>
        <translation>Drehzahlbetrieb aus</translation>
    </message>
    <message>
        <source>Read out %1</source>
        <translation>Auslesen: %1</translation>
    </message>
    <message>
        <source>Read out register %1 of the bus chip</source>
        <translation>Auslesen: Register %1 des Busbausteins</translation>
    </message>
    <message>
        <source>Cam mode, program %1</source>
        <translation>Nockenbetrieb, Programm %1</translation>
    </message>
    <message>
        <source>Position mode</source>
        <translation>Positionsbetrieb</translation>
    </message>
    <message>
        <source>Active cams: %1</source>
        <translation>Aktive Nocken: %1</translation>
    </message>
    <message>
        <source>Start of cam %1 = %2</source>
        <translation>Anfang von Nocken %1 = %2</translation>
    </message>
    <message>
        <source>Stop of cam %1 = %2</source>
        <translation>Ende von Nocken %1 = %2</translation>
    </message>
    <message>
        <source>Position beside the cams shifted by %1</source>
        <translation>Position neben den Nocken um %1 verschoben</translation>
    </message>
    <message>
        <source>Read out the active cams</source>
        <translation>Auslesen: aktive Nocken</translation>
    </message>
    <message>
        <source>Read out the start of cam %1</source>
        <translation>Auslesen: Anfang von Nocken %1</translation>
    </message>
    <message>
        <source>Read out the stop of cam %1</source>
        <translation>Auslesen: Ende von Nocken %1</translation>
    </message>
    <message>
        <source>Read out the shift of the position beside the cams</source>
        <translation>Auslesen: Verschiebung der Position neben den Nocken</translation>
    </message>
    <message>
        <source>%1 (D29 is ignored)</source>
        <translation>%1 (D29 wird nicht beachtet)</translation>
    </message>
    <message>
        <source>Manufacturer specific (D29), and the make is not known</source>
        <translation>Herstellerspezifisch (D29), Hersteller unbekannt</translation>
    </message>
    <message>
        <source>Not defined for this encoder</source>
        <translation>Für diesen Geber nicht definiert</translation>
    </message>
    <message>
        <source>position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>position %1 (Gray code %2)</source>
        <translation>Position %1 (Gray-Code %2)</translation>
    </message>
    <message>
        <source>position %1 in a coding that is not known</source>
        <translation>Position %1 in unbekannter Codierung</translation>
    </message>
    <message>
        <source>speed %1 rpm</source>
        <translation>Drehzahl %1 U/min</translation>
    </message>
    <message>
        <source>cams on: %1, position part %2</source>
        <translation>Nocken ein: %1, Positionsanteil %2</translation>
    </message>
    <message>
        <source>Processing, data %1</source>
        <translation>in Bearbeitung, Daten %1</translation>
    </message>
    <message>
        <source>%1 = %2 confirmed</source>
        <translation>%1 = %2 quittiert</translation>
    </message>
    <message>
        <source>Old confirmation: %1 = %2</source>
        <translation>Alte Quittung: %1 = %2</translation>
    </message>
    <message>
        <source>Acknowledged: %1</source>
        <translation>Bestätigt: %1</translation>
    </message>
    <message>
        <source>Self test, or read-out of %1</source>
        <translation>Selbsttest oder Auslesewert %1</translation>
    </message>
    <message>
        <source>Read-out: %1 = %2</source>
        <translation>Ausgelesen: %1 = %2</translation>
    </message>
    <message>
        <source>Read-out: register %1 of the bus chip = %2</source>
        <translation>Ausgelesen: Register %1 des Busbausteins = %2</translation>
    </message>
    <message>
        <source>Read-out: active cams %1</source>
        <translation>Ausgelesen: aktive Nocken %1</translation>
    </message>
    <message>
        <source>Read-out: start of cam %1 = %2</source>
        <translation>Ausgelesen: Anfang von Nocken %1 = %2</translation>
    </message>
    <message>
        <source>Read-out: stop of cam %1 = %2</source>
        <translation>Ausgelesen: Ende von Nocken %1 = %2</translation>
    </message>
    <message>
        <source>Read-out: position beside the cams shifted by %1</source>
        <translation>Ausgelesen: Position neben den Nocken um %1 verschoben</translation>
    </message>
    <message>
        <source>The encoder does not know the read-out code %1</source>
        <translation>Der Geber kennt den Auslesecode %1 nicht</translation>
    </message>
    <message>
        <source>No valid position</source>
        <translation>Keine gültige Position</translation>
    </message>
    <message>
        <source>Error %1: %2</source>
        <translation>Fehler %1: %2</translation>
    </message>
    <message>
        <source>Error 2: wrong cam command</source>
        <translation>Fehler 2: falscher Nockenbefehl</translation>
    </message>
    <message>
        <source>Manufacturer&apos;s error %1</source>
        <translation>Herstellerfehler %1</translation>
    </message>
    <message>
        <source>D31 D30 = 01: a state that no manual describes</source>
        <translation>D31 D30 = 01: ein Zustand, den kein Handbuch nennt</translation>
    </message>
    <message>
        <source>%1 (reset to factory settings)</source>
        <translation>%1 (auf Werkseinstellungen zurücksetzen)</translation>
    </message>
    <message>
        <source>preset adjustment</source>
        <translation>Preset-Justage</translation>
    </message>
    <message>
        <source>Service %1: read, service bit %2</source>
        <translation>Dienst %1: lesen, Dienst-Bit %2</translation>
    </message>
    <message>
        <source>Service %1: write %2, service bit %3</source>
        <translation>Dienst %1: %2 schreiben, Dienst-Bit %3</translation>
    </message>
    <message>
        <source>Service %1: write %2, service bit %3; the encoder refuses this value</source>
        <translation>Dienst %1: %2 schreiben, Dienst-Bit %3; der Geber lehnt diesen Wert ab</translation>
    </message>
    <message>
        <source>Error bit: the magnet is or was outside the measuring range; position %1</source>
        <translation>Fehlerbit: Der Magnet ist oder war außerhalb des Messbereichs; Position %1</translation>
    </message>
    <message>
        <source>Service %1: %2 written</source>
        <translation>Dienst %1: %2 geschrieben</translation>
    </message>
    <message>
        <source>Service %1: %2 read</source>
        <translation>Dienst %1: %2 gelesen</translation>
    </message>
    <message>
        <source>Old answer: service %1, %2</source>
        <translation>Alte Antwort: Dienst %1, %2</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>This encoder has no OUT word: it only sends its position</source>
        <translation>Dieser Geber hat kein OUT-Wort: Er meldet nur seine Position</translation>
    </message>
    <message>
        <source>No source describes the OUT word of a K4 encoder</source>
        <translation>Das OUT-Wort eines K4-Gebers ist in keiner Quelle beschrieben</translation>
    </message>
    <message>
        <source>position %1, as long as all four status bits are 0: no source says where they stand</source>
        <translation>Position %1, solange alle vier Statusbits 0 sind: Wo sie stehen, sagt keine Quelle</translation>
    </message>
    <message>
        <source>No position: %1 should be 0, since the position has %2 bits</source>
        <translation>Keine Position: Bei %1 wird 0 erwartet, denn die Position hat %2 Bits</translation>
    </message>
    <message>
        <source>position %1 (signed)</source>
        <translation>Position %1 (mit Vorzeichen)</translation>
    </message>
    <message>
        <source>Parameter %1 (not defined for this encoder)</source>
        <translation>Parameter %1 (bei diesem Geber nicht definiert)</translation>
    </message>
    <message>
        <source>parameter %1 (not defined for this encoder)</source>
        <translation>Parameter %1 (bei diesem Geber nicht definiert)</translation>
    </message>
    <message>
        <source>%1 (outside %2 to %3)</source>
        <translation>%1 (außerhalb %2 bis %3)</translation>
    </message>
    <message>
        <source>%1 (there are only %2)</source>
        <translation>%1 (es gibt nur %2)</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>Refused.</source>
        <translation>Abgelehnt.</translation>
    </message>
    <message>
        <source>The bus runs.</source>
        <translation>Der Bus läuft.</translation>
    </message>
    <message>
        <source>The bus is stopped.</source>
        <translation>Der Bus ist angehalten.</translation>
    </message>
    <message>
        <source>Operate: writing is allowed.</source>
        <translation>Bedienen: Schreiben ist erlaubt.</translation>
    </message>
    <message>
        <source>Watch: nothing is sent any more.</source>
        <translation>Beobachten: Es wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>OUT %1 written.</source>
        <translation>OUT %1 geschrieben.</translation>
    </message>
    <message>
        <source>Written and activated: %3 (parameters: %1, EEPROM writes: %2).</source>
        <translation>Geschrieben und aktiv: %3 (Parameter: %1, EEPROM-Schreibvorgänge: %2).</translation>
    </message>
    <message>
        <source>Values read: %1.</source>
        <translation>Ausgelesene Werte: %1.</translation>
    </message>
    <message>
        <source>Preset initialised: position %1 before, %2 after.</source>
        <translation>Preset initialisiert: Position vorher %1, nachher %2.</translation>
    </message>
    <message>
        <source>Words sent: %1.</source>
        <translation>Gesendete Worte: %1.</translation>
    </message>
    <message>
        <source>The encoder is in operation again.</source>
        <translation>Der Geber ist wieder in Betrieb.</translation>
    </message>
    <message>
        <source>The encoder was left in parameterization. Send run to bring it back to operation.</source>
        <translation>Der Geber blieb in der Parametrierung. Run bringt ihn wieder in Betrieb.</translation>
    </message>
    <message>
        <source>The encoder reports error %1 (IN %2).</source>
        <translation>Der Geber meldet Fehler %1 (IN %2).</translation>
    </message>
    <message>
        <source>The encoder reports no error any more.</source>
        <translation>Der Geber meldet keinen Fehler mehr.</translation>
    </message>
    <message>
        <source>Bus cycles that came late: %1.</source>
        <translation>Verspätete Buszyklen: %1.</translation>
    </message>
    <message>
        <source>Preset initialised.</source>
        <translation>Preset initialisiert.</translation>
    </message>
    <message>
        <source>Preset initialised: position %1 after.</source>
        <translation>Preset initialisiert: Position nachher %1.</translation>
    </message>
    <message>
        <source>Preset initialised: position %1 before.</source>
        <translation>Preset initialisiert: Position vorher %1.</translation>
    </message>
    <message>
        <source>What was known of the encoder may not hold any more: read it again.</source>
        <translation>Was vom Geber bekannt war, gilt vielleicht nicht mehr: Neu auslesen.</translation>
    </message>
    <message>
        <source>The encoder reports error %1, %3 (IN %2).</source>
        <translation>Der Geber meldet Fehler %1, %3 (IN %2).</translation>
    </message>
    <message>
        <source>IN has been 00000000 since run: position 0, or an encoder without power. Turn the shaft to be sure.</source>
        <translation>IN ist seit Run 00000000: Position 0, oder der Geber hat keine Versorgung. Zur Sicherheit die Welle drehen.</translation>
    </message>
    <message>
        <source>The encoder was switched: %1.</source>
        <translation>Der Geber wurde umgeschaltet: %1.</translation>
    </message>
    <message>
        <source>The encoder was reset to factory settings (EEPROM writes: %1).</source>
        <translation>Der Geber wurde auf Werkseinstellungen zurückgesetzt (EEPROM-Schreibvorgänge: %1).</translation>
    </message>
    <message>
        <source>Cam programs read: %1.</source>
        <translation>Gelesene Nockenprogramme: %1.</translation>
    </message>
    <message>
        <source>Cam programs written: %1 (EEPROM writes so far: %2).</source>
        <translation>Geschriebene Nockenprogramme: %1 (EEPROM-Schreibvorgänge bisher: %2).</translation>
    </message>
    <message>
        <source>The reset to factory settings waits for run. Run carries it out; switching the encoder off drops it.</source>
        <translation>Das Zurücksetzen auf Werkseinstellungen wartet auf Run. Run führt es aus; beim Ausschalten des Gebers wird es verworfen.</translation>
    </message>
    <message>
        <source>The encoder was left in service mode: it shows no position. Set OUT to 0 to bring it back to normal mode.</source>
        <translation>Der Geber blieb im Dienstbetrieb: Er zeigt keine Position. OUT auf 0 setzen bringt ihn in den Normalbetrieb zurück.</translation>
    </message>
    <message>
        <source>Connected: %1.</source>
        <translation>Verbunden: %1.</translation>
    </message>
    <message>
        <source>Disconnected.</source>
        <translation>Getrennt.</translation>
    </message>
    <message>
        <source>Bus fault: %1.</source>
        <translation>Busfehler: %1.</translation>
    </message>
    <message>
        <source>Fault: %1. Confirm it when its cause is gone.</source>
        <translation>Fehler: %1. Quittieren, wenn die Ursache behoben ist.</translation>
    </message>
    <message>
        <source>The peripheral fault was confirmed.</source>
        <translation>Der Peripheriefehler wurde quittiert.</translation>
    </message>
    <message>
        <source>Segment %1 was switched off.</source>
        <translation>Segment %1 wurde abgeschaltet.</translation>
    </message>
    <message>
        <source>Segment %1 was switched on.</source>
        <translation>Segment %1 wurde zugeschaltet.</translation>
    </message>
    <message>
        <source>The diagnostics were confirmed.</source>
        <translation>Die Diagnose wurde quittiert.</translation>
    </message>
    <message>
        <source>The ring was read in: %1 devices.</source>
        <translation>Der Ring wurde eingelesen: %1 Teilnehmer.</translation>
    </message>
    <message>
        <source>The master activated its configuration %1.</source>
        <translation>Der Master hat seine Konfiguration %1 aktiviert.</translation>
    </message>
    <message>
        <source>The master keeps the configuration %1 now (%2 devices).</source>
        <translation>Im Master ist jetzt die Konfiguration %1 gespeichert (%2 Teilnehmer).</translation>
    </message>
    <message>
        <source>The master keeps the configuration %1 (%2 devices).</source>
        <translation>Im Master ist die Konfiguration %1 gespeichert (%2 Teilnehmer).</translation>
    </message>
    <message>
        <source>The master keeps no configuration.</source>
        <translation>Im Master ist keine Konfiguration gespeichert.</translation>
    </message>
    <message>
        <source>The ring is as the project says: %1 devices.</source>
        <translation>Der Ring ist wie im Projekt: %1 Teilnehmer.</translation>
    </message>
    <message>
        <source>Fault plan: %1</source>
        <translation>Fehlerplan: %1</translation>
    </message>
    <message>
        <source>Project opened: %1.</source>
        <translation>Projekt geöffnet: %1.</translation>
    </message>
    <message>
        <source>Project saved: %1.</source>
        <translation>Projekt gespeichert: %1.</translation>
    </message>
    <message>
        <source>Stored in the project: %2 values of %1 encoders.</source>
        <translation>Im Projekt abgelegt (Geber: %1, Werte: %2).</translation>
    </message>
    <message>
        <source>Transferred to %1 encoders: %2 values written, %3 already there, %4 EEPROM writes.</source>
        <translation>Übertragen (Geber: %1, Werte geschrieben: %2, schon vorhanden: %3, EEPROM-Schreibvorgänge: %4).</translation>
    </message>
    <message>
        <source>The encoder was replaced (serial number before: %1, now: %2).</source>
        <translation>Der Geber wurde ersetzt (Seriennummer vorher: %1, jetzt: %2).</translation>
    </message>
    <message>
        <source>Values of %1 were restored: %2.</source>
        <translation>Werte von %1 wurden wiederhergestellt: %2.</translation>
    </message>
    <message>
        <source>Report saved: %1.</source>
        <translation>Bericht gespeichert: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2 What belongs there is kept only until the program ends.</source>
        <translation>%1 ist nicht verwendbar: %2 Was dort stehen soll, bleibt nur bis zum Programmende erhalten.</translation>
    </message>
    <message>
        <source>%1 was damaged. It was put aside as %2, and a new one was begun.</source>
        <translation>%1 war beschädigt. Die Datei wurde in %2 umbenannt und eine neue begonnen.</translation>
    </message>
    <message>
        <source>The serial line %1 was closed.</source>
        <translation>Die serielle Leitung %1 wurde geschlossen.</translation>
    </message>
    <message>
        <source>The serial port %1 is gone: the adapter was unplugged or has lost its supply.</source>
        <translation>Der serielle Anschluss %1 ist weg: Der Adapter wurde abgezogen oder hat keine Versorgung mehr.</translation>
    </message>
    <message>
        <source>The adapter is back: the serial line %1 is open again.</source>
        <translation>Der Adapter ist wieder da: Die serielle Leitung %1 ist wieder offen.</translation>
    </message>
    <message>
        <source>The adapter at %1 does not take low latency: answers may come up to 16 ms later.</source>
        <translation>Der Adapter an %1 lässt sich nicht auf kurze Latenz einstellen: Antworten können bis zu 16 ms später kommen.</translation>
    </message>
    <message>
        <source>The encoder does not answer any more (%1 tries).</source>
        <translation>Der Geber antwortet nicht mehr (%1 Versuche).</translation>
    </message>
    <message>
        <source>The encoder answers again.</source>
        <translation>Der Geber antwortet wieder.</translation>
    </message>
    <message>
        <source>The position %1 is suspect: %2 came before it, and the encoder cannot turn that fast. It is asked for again.</source>
        <translation>Die Position %1 ist verdächtig: Davor kam %2, und so schnell kann der Geber nicht drehen. Sie wird noch einmal abgefragt.</translation>
    </message>
    <message>
        <source>The encoder at %1 has the address %2 now.</source>
        <translation>Der Geber an %1 hat jetzt die Adresse %2.</translation>
    </message>
    <message>
        <source>The encoder answers at %2 baud now (before: %1).</source>
        <translation>Der Geber spricht jetzt mit %2 Baud (vorher: %1).</translation>
    </message>
    <message>
        <source>Encoders found on the serial line: %1 (requests: %2).</source>
        <translation>Geber an der seriellen Leitung gefunden: %1 (Anfragen: %2).</translation>
    </message>
    <message>
        <source>CRC errors in segment %1: %2 since the last message, %3 since the start.</source>
        <translation>CRC-Fehler in Segment %1: %2 seit der letzten Meldung, %3 seit dem Start.</translation>
    </message>
    <message>
        <source>The ring differs from the project (lines: %1). Compare them.</source>
        <translation>Der Ring weicht vom Projekt ab (Zeilen: %1). Beide vergleichen.</translation>
    </message>
    <message>
        <source>This program has written %1 times to the EEPROM; its manual states about %2 writes. Each further write is asked about.</source>
        <translation>Dieses Programm hat %1-mal in das EEPROM geschrieben; das Handbuch spricht von etwa %2. Ab jetzt wird vor jedem Schreiben gefragt.</translation>
    </message>
    <message>
        <source>This program has written %1 times to the EEPROM, as often as its manual states (%2). It may lose its values.</source>
        <translation>Dieses Programm hat %1-mal in das EEPROM geschrieben, so oft, wie das Handbuch angibt (%2). Der Geber kann seine Werte verlieren.</translation>
    </message>
    <message>
        <source>Segment %1 is switched off, and the place of the bus fault with it: %2. The fault may still be there. Start the bus again.</source>
        <translation>Segment %1 ist abgeschaltet, und mit ihm die Stelle des Busfehlers: %2. Der Fehler kann noch bestehen. Den Bus wieder starten.</translation>
    </message>
    <message>
        <source>No device answered when the ring was read in. Check the cable to the first device, and its supply.</source>
        <translation>Beim Einlesen des Rings hat kein Gerät geantwortet. Das Kabel zum ersten Gerät und dessen Versorgung prüfen.</translation>
    </message>
    <message>
        <source>The computer slept for %1 s: the bus is in Watch, and what was shown before is old.</source>
        <translation>Der Rechner war %1 s im Ruhezustand: Der Bus steht auf Beobachten, und was davor gezeigt wurde, ist alt.</translation>
    </message>
    <message>
        <source>EEPROM writes cannot be entered in %1: %2 They are kept in %3, and entered when the program can open it again.</source>
        <translation>EEPROM-Schreibvorgänge können nicht in %1 eingetragen werden: %2 Sie stehen in %3 und werden nachgetragen, sobald das Programm die Datei wieder öffnen kann.</translation>
    </message>
    <message>
        <source>The link to the ring is back. The bus is in Watch.</source>
        <translation>Die Verbindung zum Ring ist wieder da. Der Bus steht auf Beobachten.</translation>
    </message>
    <message>
        <source>This encoder is now treated as: %1. What was known of it is forgotten.</source>
        <translation>Dieser Geber gilt jetzt als: %1. Was über ihn bekannt war, ist vergessen.</translation>
    </message>
    <message>
        <source>The bus fault is cleared. Start the bus again.</source>
        <translation>Der Busfehler ist behoben. Den Bus wieder starten.</translation>
    </message>
    <message>
        <source>Unsaved changes of %1 were recovered.</source>
        <translation>Nicht gespeicherte Änderungen von %1 wurden zurückgeholt.</translation>
    </message>
    <message>
        <source>The message file had reached its size limit: the oldest %1 messages were dropped.</source>
        <translation>Die Meldungsdatei hatte ihre Größe erreicht: Die ältesten %1 Meldungen wurden entfernt.</translation>
    </message>
    <message>
        <source>The earlier values were written again and read back: %1 (EEPROM writes: %2).</source>
        <translation>Die vorigen Werte wurden wieder geschrieben und zurückgelesen: %1 (EEPROM-Schreibvorgänge: %2).</translation>
    </message>
    <message>
        <source>The earlier values were written again, confirmed and activated, but cannot be read: %1 (EEPROM writes: %2).</source>
        <translation>Die vorigen Werte wurden wieder geschrieben, quittiert und aktiviert, lassen sich aber nicht auslesen: %1 (EEPROM-Schreibvorgänge: %2).</translation>
    </message>
    <message>
        <source>The serial line %1 is open at %2 Bd.</source>
        <translation>Die serielle Leitung %1 ist mit %2 Bd offen.</translation>
    </message>
    <message>
        <source>Recording to %1.</source>
        <translation>Aufzeichnung nach %1.</translation>
    </message>
    <message>
        <source>The recording %1 waits for its trigger.</source>
        <translation>Die Aufzeichnung %1 wartet auf ihren Auslöser.</translation>
    </message>
    <message>
        <source>The trigger fired: recording to %1.</source>
        <translation>Der Auslöser hat angesprochen: Aufzeichnung nach %1.</translation>
    </message>
    <message>
        <source>The recording %1 goes on (values lost so far: %2).</source>
        <translation>Die Aufzeichnung %1 geht weiter (bisher verlorene Werte: %2).</translation>
    </message>
    <message>
        <source>The recording has ended: %1, %2.</source>
        <translation>Die Aufzeichnung ist beendet: %1, %2.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP have arrived: all OUT words were read back as 00000000.</source>
        <translation>Die Nullen des ALARM-STOPPs sind angekommen: Alle OUT-Worte wurden als 00000000 zurückgelesen.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were sent and acknowledged. OUT cannot be read back on this link.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden gesendet und bestätigt. OUT lässt sich über diese Verbindung nicht zurücklesen.</translation>
    </message>
    <message>
        <source>Offered to others at %1 by Modbus.</source>
        <translation>Wird anderen an %1 über Modbus angeboten.</translation>
    </message>
    <message>
        <source>No longer offered to others at %1.</source>
        <translation>Wird anderen an %1 nicht mehr angeboten.</translation>
    </message>
    <message>
        <source>The ring was disconnected, so it is no longer offered at %1.</source>
        <translation>Der Ring wurde getrennt, also wird er an %1 nicht mehr angeboten.</translation>
    </message>
    <message>
        <source>The ring has other devices now, in other registers, so it is no longer offered at %1. Offer it again.</source>
        <translation>Der Ring hat jetzt andere Teilnehmer, in anderen Registern; er wird an %1 nicht mehr angeboten. Ihn neu anbieten.</translation>
    </message>
    <message>
        <source>Another project was opened, so nothing is offered at %1 any more. Offer it again.</source>
        <translation>Ein anderes Projekt wurde geöffnet, also wird an %1 nichts mehr angeboten. Neu anbieten.</translation>
    </message>
    <message>
        <source>This ring is a real one now, so nothing is offered at %1 any more.</source>
        <translation>Dieser Ring ist jetzt ein echter, also wird an %1 nichts mehr angeboten.</translation>
    </message>
    <message>
        <source>%1 is connected to the offered ring.</source>
        <translation>%1 ist mit dem angebotenen Ring verbunden.</translation>
    </message>
    <message>
        <source>%1 has left the offered ring (requests: %2, of them writes: %3).</source>
        <translation>%1 hat den angebotenen Ring verlassen (Anfragen: %2, davon Schreibvorgänge: %3).</translation>
    </message>
    <message>
        <source>%1 was disconnected: the offered ring has as many clients as it can have.</source>
        <translation>%1 wurde getrennt: Der angebotene Ring hat schon so viele Clients, wie er haben kann.</translation>
    </message>
    <message>
        <source>More clients of the offered ring in a short time: %1 came, %2 left, %3 were refused.</source>
        <translation>Weitere Clients des angebotenen Rings in kurzer Zeit: %1 kamen, %2 gingen, %3 wurden abgewiesen.</translation>
    </message>
    <message>
        <source>The ring of seat %1 starts afresh, with factory settings.</source>
        <translation>Der Ring von Sitzplatz %1 beginnt neu, mit Werkseinstellungen.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were sent, but OUT was read back as something else: %1. Somebody else may write to it: stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden gesendet, aber OUT wurde anders zurückgelesen: %1. Vielleicht schreibt noch jemand darauf: Halten Sie die Maschine mit ihren eigenen Mitteln an.</translation>
    </message>
    <message>
        <source>The gateway says that its ring runs again.</source>
        <translation>Das Gateway sagt, dass sein Ring wieder läuft.</translation>
    </message>
    <message>
        <source>The watchdog of the gateway was acknowledged.</source>
        <translation>Der Watchdog des Gateways wurde quittiert.</translation>
    </message>
    <message>
        <source>OUT may still hold %1: the encoder may give no position. Bring it back once the bus runs again.</source>
        <translation>In OUT steht vielleicht noch %1: Der Geber liefert dann womöglich keine Position. Zurückholen, sobald der Bus wieder läuft.</translation>
    </message>
    <message>
        <source>ALARM STOP: all OUT words of the ring are set to 0.</source>
        <translation>ALARM-STOPP: alle OUT-Worte des Rings werden auf 0 gesetzt.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were sent over the lost link, but nothing acknowledges them: it is not known whether they arrived. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden über die abgebrochene Verbindung gesendet, aber nichts quittiert sie: Ob sie angekommen sind, ist nicht bekannt. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP are in the gateway, but its ring stands still: the devices may not have got them. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs sind im Gateway, aber sein Ring steht: Die Teilnehmer haben sie vielleicht nicht bekommen. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>Disconnected before the zeros of the ALARM STOP had arrived: they are not sent any more. OUT may be as it was. Stop the machine by its own means.</source>
        <translation>Getrennt, bevor die Nullen des ALARM-STOPPs angekommen waren: Sie werden nicht mehr gesendet. OUT kann sein, wie es war. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>The word for %1 was sent, and IN is 00000000: the encoder has no supply, or is at position 0.</source>
        <translation>Das Wort für %1 wurde gesendet, und IN ist 00000000: Der Geber hat keine Versorgung oder steht auf Position 0.</translation>
    </message>
    <message>
        <source>The project has the serial number %1, and the encoder reports %2: check which encoder it is, and correct the project.</source>
        <translation>Im Projekt steht die Seriennummer %1, und der Geber meldet %2: Prüfen, welcher Geber es ist, und das Projekt berichtigen.</translation>
    </message>
    <message>
        <source>ALARM STOP: 00000000 is sent to all devices of the ring.</source>
        <translation>ALARM-STOPP: 00000000 wird an alle Teilnehmer des Rings gesendet.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP have not arrived yet, or something else is still in OUT. The program goes on trying. Stop the machine by its own means. In OUT when it was last seen: %1.</source>
        <translation>Die Nullen des ALARM-STOPPs sind noch nicht angekommen, oder in OUT steht noch etwas anderes. Das Programm versucht es weiter. Die Maschine mit ihren eigenen Mitteln anhalten. In OUT, als es zuletzt gesehen wurde: %1.</translation>
    </message>
    <message>
        <source>It is not known whether the encoder has this: %1. Read it to know.</source>
        <translation>Es ist nicht bekannt, ob der Geber dies hat: %1. Auslesen, um es zu wissen.</translation>
    </message>
    <message>
        <source>Written by hand: %1. EEPROM writes: 1.</source>
        <translation>Von Hand geschrieben: %1. EEPROM-Schreibvorgänge: 1.</translation>
    </message>
    <message>
        <source>Written: %3 (parameters: %1, EEPROM writes: %2). What scales the position acts only while scaling is on.</source>
        <translation>Geschrieben: %3 (Parameter: %1, EEPROM-Schreibvorgänge: %2). Was die Position skaliert, wirkt nur, solange die Skalierung ein ist.</translation>
    </message>
    <message>
        <source>It is not known whether the encoder has this: %1. It cannot be read: compare the position with the machine, or write it again.</source>
        <translation>Es ist nicht bekannt, ob der Geber dies hat: %1. Auslesen lässt es sich nicht: Position mit der Maschine vergleichen oder erneut schreiben.</translation>
    </message>
    <message>
        <source>EEPROM writes that this perhaps cost: %1.</source>
        <translation>EEPROM-Schreibvorgänge, die das vielleicht gekostet hat: %1.</translation>
    </message>
    <message>
        <source>The transfer was cancelled (encoders that have all of it: %1, values written: %2, already there: %3, EEPROM writes: %4).</source>
        <translation>Übertragung abgebrochen (Geber, die alles haben: %1, geschriebene Werte: %2, schon vorhanden: %3, EEPROM-Schreibvorgänge: %4).</translation>
    </message>
    <message>
        <source>The transfer was cancelled, but the position was set to %5 (encoders that have all of it: %1, values written: %2, already there: %3, EEPROM writes: %4).</source>
        <translation>Übertragung abgebrochen, die Position wurde aber auf %5 gesetzt (Geber, die alles haben: %1, geschriebene Werte: %2, schon vorhanden: %3, EEPROM-Schreibvorgänge: %4).</translation>
    </message>
    <message>
        <source>The link is lost, and nothing says whether the zeros of the ALARM STOP have arrived: they are sent again and again, and once it is back. Stop the machine by its own means.</source>
        <translation>Die Verbindung ist abgebrochen, und nichts sagt, ob die Nullen des ALARM-STOPPs angekommen sind: Sie werden immer wieder gesendet, und sobald die Verbindung wieder da ist. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>The encoder is still in parameterization, as it was before: it gives no position until run is sent.</source>
        <translation>Der Geber ist weiterhin in der Parametrierung, wie schon vorher: Er gibt keine Position aus, bis Run gesendet wird.</translation>
    </message>
    <message>
        <source>The encoder was left in %1: the controller gets no position. Switch it back to position mode.</source>
        <translation>Der Geber blieb im %1: Die Steuerung bekommt keine Position. In den Positionsbetrieb zurückschalten.</translation>
    </message>
    <message>
        <source>It is not known in which mode the encoder was left: the controller may get no position. Switch it to position mode.</source>
        <translation>Es ist nicht bekannt, in welcher Betriebsart der Geber blieb: Die Steuerung bekommt vielleicht keine Position. In den Positionsbetrieb schalten.</translation>
    </message>
    <message>
        <source>Stored, in force before: %3 (parameters: %1, EEPROM writes: %2).</source>
        <translation>Gespeichert, galt schon vorher: %3 (Parameter: %1, EEPROM-Schreibvorgänge: %2).</translation>
    </message>
</context>
<context>
    <name>Mode</name>
    <message>
        <source>position mode</source>
        <translation>Positionsbetrieb</translation>
    </message>
    <message>
        <source>velocity mode</source>
        <translation>Drehzahlbetrieb</translation>
    </message>
    <message>
        <source>cam mode</source>
        <translation>Nockenbetrieb</translation>
    </message>
    <message>
        <source>cam mode, program %1</source>
        <translation>Nockenbetrieb, Programm %1</translation>
    </message>
</context>
<context>
    <name>OutcomeText</name>
    <message>
        <source>%1 written, active and read back.</source>
        <comment>names of parameters</comment>
        <translation>%1 geschrieben, aktiv und zurückgelesen.</translation>
    </message>
    <message>
        <source>Program %1 was written and read back.</source>
        <translation>Programm %1 wurde geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>Programs %1 were written and read back.</source>
        <translation>Die Programme %1 wurden geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>Program %1 was read.</source>
        <translation>Programm %1 wurde gelesen.</translation>
    </message>
    <message>
        <source>Programs %1 were read.</source>
        <translation>Die Programme %1 wurden gelesen.</translation>
    </message>
    <message>
        <source>%1: %2, set by the encoder itself with the steps.</source>
        <comment>name of a parameter, value</comment>
        <translation>%1: %2, vom Geber selbst mit den Schritten gesetzt.</translation>
    </message>
    <message>
        <source>EEPROM writes: %1.</source>
        <translation>EEPROM-Schreibvorgänge: %1.</translation>
    </message>
    <message>
        <source>Position: %1.</source>
        <translation>Position: %1.</translation>
    </message>
    <message>
        <source>Already there: %1.</source>
        <translation>Schon vorhanden: %1.</translation>
    </message>
    <message>
        <source>Values read: %1.</source>
        <translation>Ausgelesene Werte: %1.</translation>
    </message>
    <message>
        <source>Send run</source>
        <translation>Run senden</translation>
    </message>
    <message>
        <source>End the service</source>
        <translation>Dienst beenden</translation>
    </message>
    <message>
        <source>%1 written and read back.</source>
        <comment>names of parameters</comment>
        <translation>%1 geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>The encoder is in %1.</source>
        <translation>Betriebsart des Gebers: %1.</translation>
    </message>
    <message>
        <source>In which mode the encoder is now is not known.</source>
        <translation>In welcher Betriebsart der Geber jetzt ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Done before that: %1</source>
        <comment>sentences</comment>
        <translation>Davor erledigt: %1</translation>
    </message>
    <message>
        <source>%1 written, confirmed and active.</source>
        <comment>names of parameters</comment>
        <translation>%1 geschrieben, quittiert und aktiv.</translation>
    </message>
    <message>
        <source>%1 stored, in force before.</source>
        <comment>names of parameters</comment>
        <translation>%1 gespeichert, galt schon vorher.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Revolutions</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Zählrichtung</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Zählrichtung</translation>
    </message>
    <message>
        <source>Coding</source>
        <translation>Codierung</translation>
    </message>
    <message>
        <source>coding</source>
        <translation>Codierung</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Zero offset</source>
        <translation>Nullpunkt-Verschiebung</translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation>Nullpunkt-Verschiebung</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Offset</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Offset</translation>
    </message>
    <message>
        <source>Measuring range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>measuring range</source>
        <translation>Messbereich</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Preset flag</source>
        <translation>Preset-Merker</translation>
    </message>
    <message>
        <source>preset flag</source>
        <translation>Preset-Merker</translation>
    </message>
    <message>
        <source>Software version</source>
        <translation>Softwarestand</translation>
    </message>
    <message>
        <source>software version</source>
        <translation>Softwarestand</translation>
    </message>
    <message>
        <source>Operating time</source>
        <translation>Betriebszeit</translation>
    </message>
    <message>
        <source>operating time</source>
        <translation>Betriebszeit</translation>
    </message>
    <message>
        <source>Start-up mode</source>
        <translation>Anlaufbetriebsart</translation>
    </message>
    <message>
        <source>start-up mode</source>
        <translation>Anlaufbetriebsart</translation>
    </message>
    <message>
        <source>Multi-turn and steps minus 1</source>
        <translation>Multiturn und Schritte minus 1</translation>
    </message>
    <message>
        <source>multi-turn and steps minus 1</source>
        <translation>Multiturn und Schritte minus 1</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Measuring length in steps</source>
        <translation>Messlänge in Schritten</translation>
    </message>
    <message>
        <source>measuring length in steps</source>
        <translation>Messlänge in Schritten</translation>
    </message>
    <message>
        <source>External preset</source>
        <translation>Externer Preset</translation>
    </message>
    <message>
        <source>external preset</source>
        <translation>externer Preset</translation>
    </message>
    <message>
        <source>Rod length</source>
        <translation>Stablänge</translation>
    </message>
    <message>
        <source>rod length</source>
        <translation>Stablänge</translation>
    </message>
    <message>
        <source>Error status</source>
        <translation>Fehlerstatus</translation>
    </message>
    <message>
        <source>error status</source>
        <translation>Fehlerstatus</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Unterer Endschalter</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>unterer Endschalter</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Oberer Endschalter</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>oberer Endschalter</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Scaling factor</source>
        <translation>Skalierungsfaktor</translation>
    </message>
    <message>
        <source>scaling factor</source>
        <translation>Skalierungsfaktor</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Operating parameters</source>
        <translation>Betriebsparameter</translation>
    </message>
    <message>
        <source>operating parameters</source>
        <translation>Betriebsparameter</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Device code</source>
        <translation>Gerätecode</translation>
    </message>
    <message>
        <source>device code</source>
        <translation>Gerätecode</translation>
    </message>
</context>
<context>
    <name>ParameterWords</name>
    <message>
        <source>Range: %1 to %2.</source>
        <translation>Bereich: %1 bis %2.</translation>
    </message>
    <message>
        <source>Choices: %1.</source>
        <translation>Auswahl: %1.</translation>
    </message>
    <message>
        <source>Can be read, not written.</source>
        <translation>Nur lesbar, nicht schreibbar.</translation>
    </message>
    <message>
        <source>Factory setting: %1.</source>
        <translation>Werkseinstellung: %1.</translation>
    </message>
    <message>
        <source>The factory setting is not stated.</source>
        <translation>Die Werkseinstellung ist nicht angegeben.</translation>
    </message>
    <message>
        <source>Printed on the label of the encoder; it is set manually, never written.</source>
        <translation>Steht auf dem Typenschild des Gebers; wird von dort eingetragen, nie geschrieben.</translation>
    </message>
    <message>
        <source>Range: %1.</source>
        <translation>Bereich: %1.</translation>
    </message>
</context>
<context>
    <name>Participant</name>
    <message>
        <source>bus terminal</source>
        <translation>Busklemme</translation>
    </message>
    <message>
        <source>device not known</source>
        <translation>Gerät unbekannt</translation>
    </message>
</context>
<context>
    <name>Protocol</name>
    <message>
        <source>service 6</source>
        <translation>Dienst 6</translation>
    </message>
    <message>
        <source>Each command is sent once, and what was written is read back.</source>
        <translation>Jeder Befehl wird einmal gesendet, und Geschriebenes wird zurückgelesen.</translation>
    </message>
    <message>
        <source>Each word goes out for two bus cycles with its first bit, the service bit, 0; what was written is read back.</source>
        <translation>Jedes Wort geht zwei Buszyklen lang mit dem ersten Bit, dem Dienst-Bit, 0 hinaus; Geschriebenes wird zurückgelesen.</translation>
    </message>
    <message>
        <source>What will be sent</source>
        <translation>Was gesendet wird</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>%1 = %2 is out of range. Give a value from %3 to %4.</source>
        <translation>%1 = %2 liegt außerhalb des Bereichs. Einen Wert von %3 bis %4 angeben.</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Allowed are: %3.</source>
        <translation>%1 kann nicht „%2“ sein. Erlaubt: %3.</translation>
    </message>
    <message>
        <source>%1 is given twice. Give it once.</source>
        <translation>%1 ist doppelt angegeben. Nur einmal angeben.</translation>
    </message>
    <message>
        <source>%1 of the %2 can be read but not written. Leave it out.</source>
        <translation>%1: beim Geber %2 nur lesbar, nicht schreibbar. Weglassen.</translation>
    </message>
    <message>
        <source>There is nothing to do. Name at least one parameter, value or word.</source>
        <translation>Es gibt nichts zu tun. Mindestens einen Parameter, einen Wert oder ein Wort angeben.</translation>
    </message>
    <message>
        <source>There is no device at %1. There are devices at: %2.</source>
        <translation>An Platz %1 gibt es kein Gerät. Geräte gibt es an: %2.</translation>
    </message>
    <message>
        <source>The total range would be %1 steps; the largest is %2. Choose fewer steps or more revolutions.</source>
        <translation>Der Gesamtbereich wäre %1 Schritte groß; möglich sind höchstens %2. Weniger Schritte oder mehr Umdrehungen wählen.</translation>
    </message>
    <message>
        <source>%1 = %2 is outside the total range. Give a value of at most %3.</source>
        <translation>%1 = %2 liegt außerhalb des Gesamtbereichs. Höchstens %3 angeben.</translation>
    </message>
    <message>
        <source>The %2 does not have the parameter &quot;%1&quot;. Leave it out, or check which encoder it is.</source>
        <translation>Der Geber %2 hat den Parameter „%1“ nicht. Weglassen oder prüfen, welcher Geber es ist.</translation>
    </message>
    <message>
        <source>The %1 has no read-out: its values cannot be read.</source>
        <translation>Der Geber %1 kennt kein Auslesen: Seine Werte lassen sich nicht lesen.</translation>
    </message>
    <message>
        <source>The %1 cannot be parameterized over the bus.</source>
        <translation>Der Geber %1 lässt sich nicht über den Bus parametrieren.</translation>
    </message>
    <message>
        <source>The position of the %1 cannot be set over the bus.</source>
        <translation>Die Position des Gebers %1 lässt sich nicht über den Bus setzen.</translation>
    </message>
    <message>
        <source>Nothing was sent: the mode of the encoder is not known. In cam mode the word %1 %2. Make sure that the encoder is in position mode, and confirm it.</source>
        <translation>Nichts gesendet: Die Betriebsart des Gebers ist unbekannt. Im Nockenbetrieb gilt: Das Wort %1 %2. Sicherstellen, dass der Geber im Positionsbetrieb ist, und das bestätigen.</translation>
    </message>
    <message>
        <source>A job is running at %1. Wait for its end, or cancel it.</source>
        <translation>An %1 läuft ein Auftrag. Sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>A job is running at this encoder. Wait for its end, or cancel it.</source>
        <translation>An diesem Geber läuft ein Auftrag. Sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>Nothing was sent to %1: a job holds its OUT word. Wait for its end, or cancel it.</source>
        <translation>Nichts an %1 gesendet: Ein Auftrag belegt das OUT-Wort. Sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>Nothing was sent: a job holds the OUT word. Wait for its end, or cancel it.</source>
        <translation>Nichts gesendet: Ein Auftrag belegt das OUT-Wort. Sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>Nothing was sent to %1: the program only watches. Switch to Operate first.</source>
        <translation>Nichts an %1 gesendet: Das Programm beobachtet nur. Erst auf Bedienen umschalten.</translation>
    </message>
    <message>
        <source>Nothing was sent: the program only watches. Switch to Operate first.</source>
        <translation>Nichts gesendet: Das Programm beobachtet nur. Erst auf Bedienen umschalten.</translation>
    </message>
    <message>
        <source>Nothing was sent to %1: the bus is stopped. Start it first.</source>
        <translation>Nichts an %1 gesendet: Der Bus ist angehalten. Erst starten.</translation>
    </message>
    <message>
        <source>Nothing was sent: the bus is stopped. Start it first.</source>
        <translation>Nichts gesendet: Der Bus ist angehalten. Erst starten.</translation>
    </message>
    <message>
        <source>Error 1: the encoder refused the value of %1 (IN %2). Check the value and write it again.</source>
        <translation>Fehler 1: Der Geber hat den Wert für %1 abgelehnt (IN %2). Wert prüfen und neu schreiben.</translation>
    </message>
    <message>
        <source>Error 1: the encoder refused a value (IN %2). Check the values and write them again.</source>
        <translation>Fehler 1: Der Geber hat einen Wert abgelehnt (IN %2). Werte prüfen und neu schreiben.</translation>
    </message>
    <message>
        <source>Error 2: the encoder does not know the number of %1 (IN %2). Check which encoder it is.</source>
        <translation>Fehler 2: Der Geber kennt die Nummer für %1 nicht (IN %2). Prüfen, welcher Geber es ist.</translation>
    </message>
    <message>
        <source>Error 2: the encoder does not know a parameter number (IN %2). Check which encoder it is.</source>
        <translation>Fehler 2: Der Geber kennt eine Parameternummer nicht (IN %2). Prüfen, welcher Geber es ist.</translation>
    </message>
    <message>
        <source>Error 3: the encoder has lost its parameters (IN %1). Write parameters 1 to 4 again, or reset it to factory settings.</source>
        <translation>Fehler 3: Der Geber hat seine Parameter verloren (IN %1). Parameter 1 bis 4 neu schreiben oder auf Werkseinstellungen zurücksetzen.</translation>
    </message>
    <message>
        <source>Error 13: the encoder could not store its parameters (IN %1). Write them again; if the error comes back, replace the encoder.</source>
        <translation>Fehler 13: Der Geber konnte seine Parameter nicht speichern (IN %1). Neu schreiben; kommt der Fehler wieder, den Geber tauschen.</translation>
    </message>
    <message>
        <source>Error 14: the battery of the encoder is low (IN %1). Have it replaced; run brings the encoder back to operation.</source>
        <translation>Fehler 14: Die Batterie des Gebers ist schwach (IN %1). Tauschen lassen; Run bringt den Geber wieder in Betrieb.</translation>
    </message>
    <message>
        <source>Error 15: the encoder reads a faulty value from its code disc (IN %1). Send run; if the error comes back, replace the encoder.</source>
        <translation>Fehler 15: Der Geber liest einen fehlerhaften Wert von seiner Codescheibe (IN %1). Run senden; kommt der Fehler wieder, den Geber tauschen.</translation>
    </message>
    <message>
        <source>The encoder does not know the read-out code %1 (IN %2). Check which encoder it is, and whether it has what you want to read.</source>
        <translation>Der Geber kennt den Auslesecode %1 nicht (IN %2). Prüfen, welcher Geber es ist und ob er den gesuchten Wert hat.</translation>
    </message>
    <message>
        <source>The encoder reports the manufacturer&apos;s error %1 (IN %2). See its manual.</source>
        <translation>Der Geber meldet den Herstellerfehler %1 (IN %2). Siehe sein Handbuch.</translation>
    </message>
    <message>
        <source>The encoder gives no valid position (IN %1). Turn the shaft more slowly, and send run.</source>
        <translation>Der Geber liefert keine gültige Position (IN %1). Die Welle langsamer drehen und Run senden.</translation>
    </message>
    <message>
        <source>The encoder reports error %1 (IN %2), which its description does not name. See its manual.</source>
        <translation>Der Geber meldet Fehler %1 (IN %2), den seine Beschreibung nicht nennt. Siehe sein Handbuch.</translation>
    </message>
    <message>
        <source>The encoder did not answer within %1 s (OUT %2, IN %3). Check which encoder it is, and whether it is switched on.</source>
        <translation>Der Geber hat in %1 s nicht geantwortet (OUT %2, IN %3). Prüfen, welcher Geber es ist und ob er eingeschaltet ist.</translation>
    </message>
    <message>
        <source>%1 was written as %2 but read back as %3. Read the encoder before you rely on it, and write again.</source>
        <translation>%1: %2 geschrieben, aber %3 zurückgelesen. Den Geber erst auslesen, dann neu schreiben.</translation>
    </message>
    <message>
        <source>The encoder shows a state that no manual describes (IN %1). Send run, or switch the encoder off and on.</source>
        <translation>Der Geber zeigt einen Zustand, den kein Handbuch nennt (IN %1). Run senden oder den Geber aus- und einschalten.</translation>
    </message>
    <message>
        <source>The link failed: %1</source>
        <translation>Die Verbindung ist gestört: %1</translation>
    </message>
    <message>
        <source>The job was cancelled.</source>
        <translation>Der Auftrag wurde abgebrochen.</translation>
    </message>
    <message>
        <source>ALARM STOP ended the job. Check in which state it left the encoder.</source>
        <translation>ALARM-STOPP hat den Auftrag beendet. Prüfen, in welchem Zustand der Geber jetzt ist.</translation>
    </message>
    <message>
        <source>The job ended because the bus was stopped. Start the bus, and check in which state the encoder is.</source>
        <translation>Der Auftrag endete, weil der Bus angehalten wurde. Den Bus starten und prüfen, in welchem Zustand der Geber ist.</translation>
    </message>
    <message>
        <source>sets the start of cam %1 to %2</source>
        <translation>setzt den Anfang von Nocken %1 auf %2</translation>
    </message>
    <message>
        <source>sets the stop of cam %1 to %2</source>
        <translation>setzt das Ende von Nocken %1 auf %2</translation>
    </message>
    <message>
        <source>changes which cams are active</source>
        <translation>ändert, welche Nocken aktiv sind</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>Parameter %1</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>The encoder left parameterization before run was sent or answered, as after a loss of power (IN %1). It may have kept its old values: check its supply and write again.</source>
        <translation>Der Geber hat die Parametrierung verlassen, bevor Run gesendet oder beantwortet war, etwa nach einem Spannungsausfall (IN %1). Er hat vielleicht noch die alten Werte: Versorgung prüfen und noch einmal schreiben.</translation>
    </message>
    <message>
        <source>The %1 needs the position it is to be set to. Give a value.</source>
        <translation>%1 braucht die Position, auf die gesetzt werden soll. Einen Wert angeben.</translation>
    </message>
    <message>
        <source>Cam %1 cannot start or stop at %2. Give a position from 0 to %3.</source>
        <translation>Nocken %1 kann nicht bei %2 anfangen oder enden. Eine Position von 0 bis %3 angeben.</translation>
    </message>
    <message>
        <source>The shift cannot be %1. Give a value from 0 to 25.</source>
        <translation>Die Verschiebung kann nicht %1 sein. Einen Wert von 0 bis 25 angeben.</translation>
    </message>
    <message>
        <source>Cam program %1 is given twice. Give it once.</source>
        <translation>Nockenprogramm %1 ist zweimal angegeben. Einmal angeben.</translation>
    </message>
    <message>
        <source>%1, line %2, %3: %4 Nothing was taken from the file.</source>
        <translation>%1, Zeile %2, %3: %4 Aus der Datei wurde nichts übernommen.</translation>
    </message>
    <message>
        <source>&quot;%2&quot; in &quot;%1&quot; is not understood. Allowed there: %3.</source>
        <translation>„%2“ in „%1“ ist nicht bekannt. Möglich sind hier: %3.</translation>
    </message>
    <message>
        <source>The %1 has no cams.</source>
        <translation>Der Geber %1 hat keine Nocken.</translation>
    </message>
    <message>
        <source>The %1 has no velocity mode.</source>
        <translation>Der Geber %1 hat keinen Drehzahlbetrieb.</translation>
    </message>
    <message>
        <source>The %1 does not know the FRABA preset. Set the position with the preset of the profile.</source>
        <translation>Der Geber %1 kennt den FRABA-Preset nicht. Die Position mit dem Preset des Profils setzen.</translation>
    </message>
    <message>
        <source>Nothing was sent: this link cannot make sure that the word %1 stands on the bus for one cycle only. Set the position with the preset of the profile.</source>
        <translation>Nichts gesendet: Diese Verbindung kann nicht sicherstellen, dass das Wort %1 nur einen Zyklus lang auf dem Bus steht. Die Position mit dem Preset des Profils setzen.</translation>
    </message>
    <message>
        <source>The %1 cannot be reset to factory settings over the bus.</source>
        <translation>Der Geber %1 lässt sich nicht über den Bus auf Werkseinstellungen zurücksetzen.</translation>
    </message>
    <message>
        <source>The %1 cannot do this.</source>
        <translation>Der Geber %1 kann das nicht.</translation>
    </message>
    <message>
        <source>Error 98000004: a start or stop of cam %1 is above the largest position (IN %2). Give a position within the total range.</source>
        <translation>Fehler 98000004: Anfang oder Ende von Nocken %1 liegt über der größten Position (IN %2). Eine Position innerhalb des Gesamtbereichs angeben.</translation>
    </message>
    <message>
        <source>Cam program %1 was written but read back differently. Compare it before you rely on it, and write again.</source>
        <translation>Nockenprogramm %1 wurde geschrieben, aber anders zurückgelesen. Vor dem Gebrauch vergleichen und noch einmal schreiben.</translation>
    </message>
    <message>
        <source>The encoder refused service %1 (IN %2). Nothing was changed: check the value and write it again.</source>
        <translation>Der Geber hat Dienst %1 abgelehnt (IN %2). Es wurde nichts geändert: Den Wert prüfen und noch einmal schreiben.</translation>
    </message>
    <message>
        <source>The magnet is outside the measuring range (IN %1): the last position is shown. Move the magnet back, then read the error status.</source>
        <translation>Der Magnet ist außerhalb des Messbereichs (IN %1): Die letzte Position wird gezeigt. Den Magneten zurückschieben, dann den Fehlerstatus lesen.</translation>
    </message>
    <message>
        <source>%1, line %2: %4 Nothing was taken from the file.</source>
        <translation>%1, Zeile %2: %4 Aus der Datei wurde nichts übernommen.</translation>
    </message>
    <message>
        <source>Nothing was sent: the encoder is in cam mode, where the word %1 %2. Switch it to position mode first.</source>
        <translation>Nichts gesendet: Der Geber ist im Nockenbetrieb. Dort gilt: Das Wort %1 %2. Zuerst in den Positionsbetrieb schalten.</translation>
    </message>
    <message>
        <source>%1: %2 This description was left out; all others were taken.</source>
        <translation>%1: %2 Diese Beschreibung wurde ausgelassen, alle anderen wurden übernommen.</translation>
    </message>
    <message>
        <source>%1 has the device code %2: it cannot be the %3, which has %4. Choose an encoder of the same device code.</source>
        <translation>%1 hat den Gerätecode %2 und kann kein %3 sein: Dieser hat %4. Einen Geber mit demselben Gerätecode wählen.</translation>
    </message>
    <message>
        <source>sets the shift to %1</source>
        <translation>setzt die Verschiebung auf %1</translation>
    </message>
    <message>
        <source>switches to cam program %1</source>
        <translation>schaltet auf Nockenprogramm %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; ends too early. What may follow: %3.</source>
        <translation>„%1“ endet zu früh. Folgen kann: %3.</translation>
    </message>
    <message>
        <source>&quot;%2&quot; in &quot;%1&quot; is too much: the key ends before it. Leave it out.</source>
        <translation>„%2“ in „%1“ ist zu viel: Der Schlüssel endet davor. Weglassen.</translation>
    </message>
    <message>
        <source>%1 has no OUT word: nothing can be sent to it.</source>
        <translation>%1 hat kein OUT-Wort: Es lässt sich nichts dorthin senden.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1 has %2 MB; the largest file that is read has %3 MB. Is it the right file?</source>
        <translation>%1 hat %2 MB; gelesen werden Dateien bis %3 MB. Ist es die richtige Datei?</translation>
    </message>
    <message>
        <source>%1, line %2, %3: %4 The project was not opened.</source>
        <translation>%1, Zeile %2, %3: %4 Das Projekt wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>%1, line %2: %4 The project was not opened.</source>
        <translation>%1, Zeile %2: %4 Das Projekt wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>%1 was saved by a newer Codewheel (version %2 of the file; this one reads up to %3). Open it with that one. Nothing was changed.</source>
        <translation>%1 wurde von einem neueren Codewheel gespeichert (Dateiversion %2; dieses liest bis %3). Die Datei mit dem neueren öffnen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1, line %2, %3: %4 The fault plan was not loaded.</source>
        <translation>%1, Zeile %2, %3: %4 Der Fehlerplan wurde nicht geladen.</translation>
    </message>
    <message>
        <source>%1, line %2: %4 The fault plan was not loaded.</source>
        <translation>%1, Zeile %2: %4 Der Fehlerplan wurde nicht geladen.</translation>
    </message>
    <message>
        <source>The bus cannot be built like this: %1</source>
        <translation>So lässt sich der Bus nicht aufbauen: %1</translation>
    </message>
    <message>
        <source>The project has no device at %1. It has: %2.</source>
        <translation>Das Projekt hat keinen Teilnehmer %1. Vorhanden sind: %2.</translation>
    </message>
    <message>
        <source>The project has no devices. Insert one, or read in the ring.</source>
        <translation>Das Projekt hat keine Teilnehmer. Einen einfügen oder den Ring einlesen.</translation>
    </message>
    <message>
        <source>This link does not reach the master: %1 is not possible. It shows the process data only.</source>
        <translation>Diese Verbindung erreicht den Master nicht: „%1“ ist nicht möglich. Sie zeigt nur die Prozessdaten.</translation>
    </message>
    <message>
        <source>%1 (%2) and %3 (%4) are not the same kind of encoder. Choose encoders of one kind.</source>
        <translation>%1 (%2) und %3 (%4) sind nicht von derselben Art. Geber einer Art wählen.</translation>
    </message>
    <message>
        <source>%1 is not possible while the master is in the state %2.</source>
        <translation>„%1“ ist nicht möglich, solange der Master im Zustand %2 ist.</translation>
    </message>
    <message>
        <source>The master has no stored configuration. Read in the ring, or download one.</source>
        <translation>Im Master ist keine Konfiguration gespeichert. Den Ring einlesen oder eine Konfiguration laden.</translation>
    </message>
    <message>
        <source>%1: this program has written %2 times to its EEPROM; its manual states about %3 writes. Confirm that you want to write.</source>
        <translation>%1: Dieses Programm hat %2-mal in das EEPROM geschrieben; das Handbuch spricht von etwa %3. Das Schreiben ausdrücklich bestätigen.</translation>
    </message>
    <message>
        <source>%1: this program has written %2 times to its EEPROM; beyond %3 its manual guarantees nothing. Type the place to write nevertheless.</source>
        <translation>%1: Dieses Programm hat %2-mal in das EEPROM geschrieben; über %3 hinaus sichert das Handbuch nichts zu. Um trotzdem zu schreiben, den Platz eintippen.</translation>
    </message>
    <message>
        <source>There is nothing to restore at %1: no values from before a write are kept.</source>
        <translation>Bei %1 gibt es nichts wiederherzustellen: Von vor einem Schreiben sind keine Werte aufbewahrt.</translation>
    </message>
    <message>
        <source>%1: configured is %2, found was %3. Compare, and take over what is right.</source>
        <translation>%1: projektiert ist %2, gefunden wurde %3. Vergleichen und das Richtige übernehmen.</translation>
    </message>
    <message>
        <source>The bus does not run: %1.</source>
        <translation>Der Bus läuft nicht: %1.</translation>
    </message>
    <message>
        <source>%1 is not in the ring: its segment is switched off, or a fault lies before it.</source>
        <translation>%1 ist nicht im Ring: Das Segment ist abgeschaltet, oder davor liegt ein Fehler.</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation>%1 ist nicht verwendbar: %2</translation>
    </message>
    <message>
        <source>The serial line cannot be set to &quot;%1&quot;. Allowed are: %2.</source>
        <translation>Die serielle Leitung lässt sich nicht auf „%1“ einstellen. Erlaubt: %2.</translation>
    </message>
    <message>
        <source>Address %1 is taken: %2 answers there. Choose another, or two encoders would answer at once.</source>
        <translation>Adresse %1 ist vergeben: Dort antwortet %2. Eine andere wählen, sonst antworten zwei Geber zugleich.</translation>
    </message>
    <message>
        <source>The encoder does not know the command %1 (answer 03). Nothing was changed; its version may be older than the manual.</source>
        <translation>Der Geber kennt den Befehl %1 nicht (Antwort 03). Nichts wurde geändert; seine Version ist vielleicht älter als das Handbuch.</translation>
    </message>
    <message>
        <source>The encoder refused %1 as incomplete or out of range (answer 05). It kept the old value: give another one.</source>
        <translation>Der Geber hat %1 als unvollständig oder außerhalb des Bereichs abgelehnt (Antwort 05). Er hat den alten Wert behalten: Einen anderen angeben.</translation>
    </message>
    <message>
        <source>%1 was read as %2 and then as %3, so neither is taken. Check the line for disturbances, then read again.</source>
        <translation>%1 wurde als %2 und dann als %3 gelesen, daher gilt keiner der Werte. Leitung auf Störungen prüfen, dann noch einmal lesen.</translation>
    </message>
    <message>
        <source>%1 was sent and not answered, and the encoder still has the old value. Check the line, then write again.</source>
        <translation>%1 wurde gesendet, aber nicht beantwortet; der Geber hat noch den alten Wert. Leitung prüfen, dann noch einmal schreiben.</translation>
    </message>
    <message>
        <source>The encoder does not answer any more at %1. Search the line for it at all baud rates.</source>
        <translation>Der Geber antwortet auf %1 nicht mehr. Die Leitung mit allen Baudraten nach ihm absuchen.</translation>
    </message>
    <message>
        <source>There is no serial port %1. Plug the adapter in, and choose a port from the list.</source>
        <translation>Es gibt keinen seriellen Anschluss %1. Den Adapter einstecken und einen Anschluss aus der Liste wählen.</translation>
    </message>
    <message>
        <source>The serial port %1 is used by another program. Close that program, then connect again.</source>
        <translation>Den seriellen Anschluss %1 benutzt ein anderes Programm. Dieses schließen, dann neu verbinden.</translation>
    </message>
    <message>
        <source>The serial port %1 is gone: the adapter was unplugged or has lost its supply. Plug it in again.</source>
        <translation>Der serielle Anschluss %1 ist weg: Der Adapter wurde abgezogen oder hat keine Versorgung mehr. Wieder einstecken.</translation>
    </message>
    <message>
        <source>%1 is another adapter than %2. Choose the port again if you mean this one.</source>
        <translation>%1 ist ein anderer Adapter als %2. Den Anschluss neu wählen, wenn dieser gemeint ist.</translation>
    </message>
    <message>
        <source>The serial line is not open. Connect it first.</source>
        <translation>Die serielle Leitung ist nicht offen. Zuerst verbinden.</translation>
    </message>
    <message>
        <source>The encoder took no cam word (OUT %1, IN %2): it was in a parameterization that was begun before. Run was not sent, since it makes valid what was confirmed there. End that parameterization first, then try again.</source>
        <translation>Der Geber hat kein Nockenwort angenommen (OUT %1, IN %2): Er war in einer früher begonnenen Parametrierung. Run wurde nicht gesendet, denn es macht gültig, was dort quittiert wurde. Erst diese Parametrierung beenden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>is a wrong command</source>
        <translation>ist ein falscher Befehl</translation>
    </message>
    <message>
        <source>The job ended after %1 was sent and before it was answered: it is not known whether the encoder has the new value. Read it before you go on.</source>
        <translation>Der Auftrag endete, nachdem %1 gesendet war und bevor die Antwort kam: Ob der Geber den neuen Wert hat, ist nicht bekannt. Vor dem Weitermachen auslesen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2 Nothing was changed there.</source>
        <translation>%1 lässt sich nicht schreiben: %2 Dort wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The encoder refused the word %1, which %2 in cam mode (IN %3). It kept the old value: compare the cam program with the encoder, and check which encoder it is.</source>
        <translation>Der Geber hat das Wort %1 abgelehnt (im Nockenbetrieb gilt: es %2; IN %3). Der alte Wert gilt weiter: Das Nockenprogramm mit dem Geber vergleichen und prüfen, welcher Geber es ist.</translation>
    </message>
    <message>
        <source>Error 3: the encoder has lost its parameters (IN %1). In cam mode it takes none: switch it to position mode, write parameters 1 to 4 there or reset it to factory settings, and compare the cam programs.</source>
        <translation>Fehler 3: Der Geber hat seine Parameter verloren (IN %1). Im Nockenbetrieb nimmt er keine an: In den Positionsbetrieb schalten, dort Parameter 1 bis 4 schreiben oder auf Werkseinstellungen zurücksetzen, danach die Nockenprogramme vergleichen.</translation>
    </message>
    <message>
        <source>%1 was sent and not answered, and it could not be found out afterwards whether it was carried out: it is not known whether the encoder has the new value. Check the line, and read the encoder before you go on.</source>
        <translation>%1 wurde gesendet, aber nicht beantwortet, und danach ließ sich nicht feststellen, ob es ausgeführt wurde: Ob der Geber den neuen Wert hat, ist nicht bekannt. Die Leitung prüfen und den Geber auslesen, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>Error 98000004: a start or stop of a cam is above the largest position (IN %1). Compare the cam programs with the total range.</source>
        <translation>Fehler 98000004: Anfang oder Ende eines Nockens liegt über der größten Position (IN %1). Die Nockenprogramme mit dem Gesamtbereich vergleichen.</translation>
    </message>
    <message>
        <source>No answer to %1 (tries: %2). Check address, baud rate, wiring and supply; an RS-422 encoder also needs ST (pin 7) at +UB.</source>
        <translation>Keine Antwort auf %1 (Versuche: %2). Adresse, Baudrate, Verdrahtung und Versorgung prüfen; ein RS-422-Geber braucht außerdem ST (Pin 7) an +UB.</translation>
    </message>
    <message>
        <source>%1: %2 Give a value from %3 to %4.</source>
        <translation>%1: %2 Einen Wert von %3 bis %4 eingeben.</translation>
    </message>
    <message>
        <source>The job ended because the computer slept. Check in which state the encoder is, and change to Operate before you write again.</source>
        <translation>Der Auftrag endete, weil der Rechner in den Ruhezustand ging. Prüfen, in welchem Zustand der Geber ist, und vor dem nächsten Schreiben auf Bedienen schalten.</translation>
    </message>
    <message>
        <source>%1 was accepted, but neither the preset value nor the position shows that the position was set to %2: it is not known whether it was. Check the line, and read position and preset before you go on.</source>
        <translation>%1 wurde angenommen, aber weder Presetwert noch Position zeigen, dass die Position auf %2 gesetzt wurde: Ob sie es wurde, ist nicht bekannt. Die Leitung prüfen und Position und Preset lesen, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address of an encoder on a serial line. Addresses go from 01 to 1F (1 to 31); 00 is for an encoder that is alone on its line.</source>
        <translation>„%1“ ist keine Adresse eines Gebers an einer seriellen Leitung. Adressen gehen von 01 bis 1F (1 bis 31); 00 ist für einen Geber, der allein an seiner Leitung ist.</translation>
    </message>
    <message>
        <source>Every encoder answers to address %1: it is for an encoder that is alone on its line, and there is %2 too. Use the address of the encoder itself.</source>
        <translation>Auf die Adresse %1 antwortet jeder Geber: Sie ist für einen Geber, der allein an seiner Leitung ist, und hier ist auch %2. Die eigene Adresse des Gebers verwenden.</translation>
    </message>
    <message>
        <source>%1 does not answer. Check address, baud rate, wiring and supply.</source>
        <translation>%1 antwortet nicht. Adresse, Baudrate, Verdrahtung und Versorgung prüfen.</translation>
    </message>
    <message>
        <source>%1 is not connected. Connect its bus, and look which devices are there.</source>
        <translation>%1 ist nicht verbunden. Den Bus verbinden und nachsehen, welche Teilnehmer da sind.</translation>
    </message>
    <message>
        <source>%1: planned is %2, connected is %3. Connect what is planned, or plan what is connected.</source>
        <translation>%1: geplant ist %2, verbunden ist %3. Das Geplante anschließen oder das Verbundene planen.</translation>
    </message>
    <message>
        <source>%1: the label in the project has the serial number %2, the encoder reports %3. Replace the encoder in the project, or correct the label.</source>
        <translation>%1: Auf dem Typenschild im Projekt steht die Seriennummer %2, der Geber meldet %3. Den Geber im Projekt ersetzen oder das Typenschild berichtigen.</translation>
    </message>
    <message>
        <source>The %2 belongs to another kind of bus: it cannot be the device at %1.</source>
        <translation>Der %2 gehört an eine andere Art von Bus: Er kann nicht das Gerät an %1 sein.</translation>
    </message>
    <message>
        <source>Cam %1 cannot go through zero: the positions of this encoder do not lie in a circle. Give a stop that is not below the start.</source>
        <translation>Nocken %1 kann nicht über null gehen: Die Positionen dieses Gebers liegen nicht im Kreis. Ein Ende angeben, das nicht unter dem Anfang liegt.</translation>
    </message>
    <message>
        <source>Cam %1 has a hysteresis or a polarity that this encoder does not know. Set them to 0 and off.</source>
        <translation>Nocken %1 hat eine Hysterese oder eine Polarität, die dieser Geber nicht kennt. Hysterese auf 0 und Polarität auf aus setzen.</translation>
    </message>
    <message>
        <source>There is no cam program %1. Choose a program from 1 to %2.</source>
        <translation>Es gibt kein Nockenprogramm %1. Ein Programm von 1 bis %2 wählen.</translation>
    </message>
    <message>
        <source>There is no cam %1. Choose a cam from 0 to %2.</source>
        <translation>Es gibt keinen Nocken %1. Einen Nocken von 0 bis %2 wählen.</translation>
    </message>
    <message>
        <source>The shift cannot be %1: this encoder does not shift its position. Set it to 0.</source>
        <translation>Die Verschiebung kann nicht %1 sein: Dieser Geber verschiebt seine Position nicht. Auf 0 setzen.</translation>
    </message>
    <message>
        <source>The resolution would be finer than the encoder&apos;s %3 steps per turn (steps: %1, revolutions: %2). Choose fewer steps or more revolutions.</source>
        <translation>Die Auflösung wäre feiner als die %3 Schritte je Umdrehung des Gebers (Schritte: %1, Umdrehungen: %2). Weniger Schritte oder mehr Umdrehungen wählen.</translation>
    </message>
    <message>
        <source>%1 contains cam program %2, not %3. Choose program %2, or another file.</source>
        <translation>%1 enthält Nockenprogramm %2, nicht %3. Programm %2 oder eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>The scaling factor %1 fits %2 steps per turn and a measuring range of %3 in no format, or in more than one. Leave the number of fraction bits unchanged, or write the scaling again.</source>
        <translation>Der Skalierungsfaktor %1 passt zu %2 Schritten je Umdrehung und einem Messbereich von %3 in keinem oder in mehreren Formaten. Die Anzahl der Nachkommabits unverändert lassen oder die Skalierung neu schreiben.</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was read here. It was left unchanged; nothing was saved. Read it again.</source>
        <translation>Ein anderes Programm hat %1 geändert, seit die Datei hier gelesen wurde. Sie blieb unverändert; nichts wurde gespeichert. Die Datei neu lesen.</translation>
    </message>
    <message>
        <source>There is already a file %1. A recording is never written over another file: choose another name, or remove that file.</source>
        <translation>Die Datei %1 gibt es schon. Eine Aufzeichnung wird nie über eine andere Datei geschrieben: einen anderen Namen wählen oder diese Datei entfernen.</translation>
    </message>
    <message>
        <source>%1 was moved, replaced or removed while it was being recorded to: the recording has ended. Begin another one.</source>
        <translation>%1 wurde während der Aufzeichnung verschoben, ersetzt oder entfernt: Die Aufzeichnung ist beendet. Eine neue beginnen.</translation>
    </message>
    <message>
        <source>The disk of %1 is almost full: %2 MB are free, and %3 MB are to stay free. The recording waits. Make room.</source>
        <translation>Der Datenträger von %1 ist fast voll: %2 MB sind frei, und %3 MB sollen frei bleiben. Die Aufzeichnung wartet. Platz schaffen.</translation>
    </message>
    <message>
        <source>Some values of %1 cannot be read: the file is damaged (blocks: %2). There are gaps instead.</source>
        <translation>Einige Werte aus %1 lassen sich nicht lesen: Die Datei ist beschädigt (Blöcke: %2). An ihrer Stelle sind Lücken.</translation>
    </message>
    <message>
        <source>This is a recording: nothing is sent.</source>
        <translation>Dies ist eine Aufzeichnung: Es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>The address of the server is wrong. %1</source>
        <translation>Die Adresse des Servers ist falsch. %1</translation>
    </message>
    <message>
        <source>A password must not be in the address of a server. Put it into ~/.pgpass, into the file that PGPASSFILE names, or into PGPASSWORD.</source>
        <translation>In die Adresse eines Servers gehört kein Passwort. Es steht in ~/.pgpass, in der Datei, die PGPASSFILE nennt, oder in PGPASSWORD.</translation>
    </message>
    <message>
        <source>A recording on a server can be kept to its last hours, but not to a size.</source>
        <translation>Eine Aufzeichnung auf einem Server lässt sich auf ihre letzten Stunden begrenzen, aber nicht auf eine Größe.</translation>
    </message>
    <message>
        <source>%1 does not take the recording: %2 What is recorded waits on this computer, and follows (MB that wait: %3).</source>
        <translation>%1 nimmt die Aufzeichnung nicht an: %2 Was aufgezeichnet wird, wartet auf diesem Rechner und folgt (wartende MB: %3).</translation>
    </message>
    <message>
        <source>Not all of the recording is in %1: %2 The rest (MB: %3) waits in %4, and follows with the next recording to this server.</source>
        <translation>Die Aufzeichnung ist nicht vollständig in %1: %2 Der Rest (MB: %3) wartet in %4 und folgt mit der nächsten Aufzeichnung auf diesen Server.</translation>
    </message>
    <message>
        <source>Nothing is recorded in %1 as yet.</source>
        <translation>In %1 ist noch nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>The setting %1 of the link cannot be &quot;%2&quot;. Allowed: %3.</source>
        <translation>Die Einstellung %1 der Verbindung kann nicht „%2“ sein. Erlaubt: %3.</translation>
    </message>
    <message>
        <source>The link has no setting &quot;%1&quot;. Its settings are: %2.</source>
        <translation>Die Verbindung hat keine Einstellung „%1“. Es gibt: %2.</translation>
    </message>
    <message>
        <source>%1 Change the registers of the link.</source>
        <translation>%1 Die Register der Verbindung ändern.</translation>
    </message>
    <message>
        <source>The project has no devices on this ring, and a gateway cannot say which there are. Enter them in the bus structure first.</source>
        <translation>Das Projekt hat keine Teilnehmer an diesem Ring, und ein Gateway kann nicht sagen, welche es gibt. Sie zuerst im Busaufbau eintragen.</translation>
    </message>
    <message>
        <source>The OUT words cannot be read back: what is there now is not known. Operate replaces it.</source>
        <translation>Die OUT-Worte lassen sich nicht zurücklesen: Was jetzt dort steht, ist unbekannt. Bedienen ersetzt es.</translation>
    </message>
    <message>
        <source>A gateway cannot say which devices are in the ring: the project does. Enter them there.</source>
        <translation>Ein Gateway kann nicht sagen, welche Teilnehmer im Ring sind: Das sagt das Projekt. Sie dort eintragen.</translation>
    </message>
    <message>
        <source>Somebody else writes to %1: OUT is %3 there instead of %2. The bus is in Watch now. Stop the other program or PLC first.</source>
        <translation>Auf %1 schreibt noch jemand: OUT ist dort %3 statt %2. Der Bus ist jetzt auf Beobachten. Erst das andere Programm oder die SPS anhalten.</translation>
    </message>
    <message>
        <source>There is no host &quot;%1&quot; in this network. Check its name, or give its address.</source>
        <translation>In diesem Netz gibt es keinen Host „%1“. Den Namen prüfen oder die Adresse angeben.</translation>
    </message>
    <message>
        <source>%1 refuses the connection. Check the port, and whether Modbus/TCP is switched on there.</source>
        <translation>%1 lehnt die Verbindung ab. Den Port prüfen, und ob Modbus/TCP dort eingeschaltet ist.</translation>
    </message>
    <message>
        <source>%1 cannot be reached: no answer within %2 s. Check address, cable and supply.</source>
        <translation>%1 ist nicht erreichbar: keine Antwort innerhalb von %2 s. Adresse, Kabel und Versorgung prüfen.</translation>
    </message>
    <message>
        <source>%1 has closed the connection. It may serve only a few clients at once.</source>
        <translation>%1 hat die Verbindung beendet. Vielleicht bedient es nur wenige Clients zugleich.</translation>
    </message>
    <message>
        <source>Port %1 is used by another program. End it, or take another port.</source>
        <translation>Port %1 wird von einem anderen Programm benutzt. Es beenden oder einen anderen Port nehmen.</translation>
    </message>
    <message>
        <source>This computer does not have the address %1. Take one of its own, or 0.0.0.0 for all it has.</source>
        <translation>Dieser Rechner hat die Adresse %1 nicht. Eine eigene nehmen, oder 0.0.0.0 für alle, die er hat.</translation>
    </message>
    <message>
        <source>%1 does not answer (%2, tries: %3). Check unit number, settings of the line, and supply.</source>
        <translation>%1 antwortet nicht (%2, Versuche: %3). Unit-Nummer, Einstellungen der Leitung und Versorgung prüfen.</translation>
    </message>
    <message>
        <source>%1 refuses %2 with exception %3: %4</source>
        <translation>%1 lehnt %2 mit Exception %3 ab: %4</translation>
    </message>
    <message>
        <source>The answer of %1 to %2 is wrong: %3</source>
        <translation>Die Antwort von %1 auf %2 ist falsch: %3</translation>
    </message>
    <message>
        <source>Somebody else writes to the outputs of this bus: it is in Watch now.</source>
        <translation>Auf die Ausgänge dieses Busses schreibt noch jemand: Er ist jetzt auf Beobachten.</translation>
    </message>
    <message>
        <source>A real ring is never offered to others, only a training bus.</source>
        <translation>Ein echter Ring wird anderen nie angeboten, nur ein Übungsbus.</translation>
    </message>
    <message>
        <source>The ring of this window is not connected. Connect it, or give each seat a ring of its own.</source>
        <translation>Der Ring dieses Fensters ist nicht verbunden. Ihn verbinden, oder jedem Sitzplatz einen eigenen Ring geben.</translation>
    </message>
    <message>
        <source>You may not use the serial port %1: it belongs to the group %2. Run &quot;%3&quot;. If that adds you to a group, log out and in again.</source>
        <translation>Der serielle Anschluss %1 darf nicht benutzt werden: Er gehört der Gruppe %2. „%3“ ausführen. Nimmt das in eine Gruppe auf, dann ab- und wieder anmelden.</translation>
    </message>
    <message>
        <source>Only an administrator may serve at port %1. Take a higher one, such as 1502.</source>
        <translation>An Port %1 darf nur ein Administrator etwas anbieten. Einen höheren nehmen, etwa 1502.</translation>
    </message>
    <message>
        <source>The position was not set: the encoder shows %2, and would show %1. Make sure that its OUT word reaches it, then set the position again.</source>
        <translation>Die Position wurde nicht gesetzt: Der Geber zeigt %2 und würde sonst %1 zeigen. Stellen Sie sicher, dass sein OUT-Wort ihn erreicht, und setzen Sie die Position noch einmal.</translation>
    </message>
    <message>
        <source>The position was not set: the encoder shows %2, and would show %1. It had used its preset up (preset flag 0): write the preset again, then set the position.</source>
        <translation>Die Position wurde nicht gesetzt: Der Geber zeigt %2 und würde sonst %1 zeigen. Sein Preset war verbraucht (Preset-Flag 0): Schreiben Sie den Preset neu, und setzen Sie dann die Position.</translation>
    </message>
    <message>
        <source>The preset was sent, but it is not known whether the position was set, since it is not known what the encoder has for: %1. It shows %2: compare that with the machine. It can be told where that value was written from here before.</source>
        <translation>Der Preset wurde gesendet, aber ob die Position gesetzt wurde, ist nicht bekannt, weil nicht bekannt ist, was der Geber hat für: %1. Er zeigt %2: Vergleichen Sie das mit der Maschine. Sagen lässt es sich, wenn dieser Wert vorher von hier geschrieben wurde.</translation>
    </message>
    <message>
        <source>The preset was sent, but it is not known whether the position was set: the encoder shows %1, which does not tell. Compare it with the machine before you go on.</source>
        <translation>Der Preset wurde gesendet, aber ob die Position gesetzt wurde, ist nicht bekannt: Der Geber zeigt %1, und das verrät es nicht. Vergleichen Sie es mit der Maschine, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>The gateway says that its ring does not run (status register %1): what it shows is old. Start the ring at its master.</source>
        <translation>Das Gateway sagt, dass sein Ring nicht läuft (Statusregister %1): Was es zeigt, ist alt. Starten Sie den Ring an seinem Master.</translation>
    </message>
    <message>
        <source>The gateway says that its ring has failed (status register %1): what it shows is old. Look at the display of its master.</source>
        <translation>Das Gateway sagt, dass sein Ring ausgefallen ist (Statusregister %1): Was es zeigt, ist alt. Sehen Sie auf die Anzeige seines Masters.</translation>
    </message>
    <message>
        <source>The gateway says that its ring has failed (status register %1): what it shows is old. The place it names is %2: check plugs, shields and 24 V there.</source>
        <translation>Das Gateway sagt, dass sein Ring ausgefallen ist (Statusregister %1): Was es zeigt, ist alt. Es nennt den Ort %2: Prüfen Sie dort Stecker, Schirme und 24 V.</translation>
    </message>
    <message>
        <source>%1 answers too late (%2, tries: %3): what comes is for earlier requests. Set a longer time-out.</source>
        <translation>%1 antwortet zu spät (%2, Versuche: %3): Was kommt, gehört zu früheren Anfragen. Stellen Sie eine längere Zeitgrenze ein.</translation>
    </message>
    <message>
        <source>No register is set that acknowledges the watchdog of this gateway. Enter it and its value, by the manual of the gateway, in the connection.</source>
        <translation>Es ist kein Register eingetragen, das den Watchdog dieses Gateways quittiert. Tragen Sie es mit seinem Wert nach dem Handbuch des Gateways in der Verbindung ein.</translation>
    </message>
    <message>
        <source>%1 does not carry out %2 (exception 4). The watchdog of its outputs may have tripped: acknowledge it, then go to Operate again.</source>
        <translation>%1 führt %2 nicht aus (Exception 4). Der Watchdog seiner Ausgänge hat vielleicht angesprochen: Quittieren Sie ihn und schalten Sie dann wieder auf Bedienen.</translation>
    </message>
    <message>
        <source>The encoder did not answer within %1 s (OUT %2, IN %3). Check the first register of OUT in the connection: its words may go elsewhere. Then check which encoder it is, and whether it is switched on.</source>
        <translation>Der Geber hat nicht innerhalb von %1 s geantwortet (OUT %2, IN %3). In der Verbindung das erste Register von OUT prüfen: Seine Worte gehen vielleicht woandershin. Dann prüfen, welcher Geber es ist und ob er eingeschaltet ist.</translation>
    </message>
    <message>
        <source>The encoder has lost its parameters, and works again only with all of parameters 1 to 4. Without a value: %1. Give them one; nothing is sent before.</source>
        <translation>Der Geber hat seine Parameter verloren und arbeitet erst wieder mit allen Parametern 1 bis 4. Ohne Wert: %1. Geben Sie einen an; vorher wird nichts gesendet.</translation>
    </message>
    <message>
        <source>The encoder seems to answer differently each time (IN %1): the gateway puts halves of different words together. Set a longer copy time in the settings of the gateway, then read again.</source>
        <translation>Der Geber scheint jedes Mal anders zu antworten (IN %1): Das Gateway setzt Hälften verschiedener Wörter zusammen. In den Einstellungen des Gateways eine längere Kopierzeit einstellen, dann noch einmal auslesen.</translation>
    </message>
    <message>
        <source>Say first whether the encoder at %1 is the same as before.</source>
        <translation>Zuerst angeben, ob der Geber an %1 noch derselbe ist.</translation>
    </message>
    <message>
        <source>No two reads of IN of %1 agree, so it is not known what it shows. Check the word order, and where its registers begin. If they are right, its shaft is too fast for this gateway: stop it, or make the poll interval shorter.</source>
        <translation>Keine zwei Lesungen von IN von %1 stimmen überein, also ist nicht bekannt, was er zeigt. Die Reihenfolge der Worte prüfen, und wo seine Register beginnen. Stimmen sie, so ist seine Welle zu schnell für dieses Gateway: anhalten, oder das Abfrageintervall verkürzen.</translation>
    </message>
    <message>
        <source>Nothing was written: the encoder is in parameterization already (IN %1). End that first, with run.</source>
        <translation>Nichts geschrieben: Der Geber ist schon in der Parametrierung (IN %1). Diese erst mit Run beenden.</translation>
    </message>
    <message>
        <source>The encoder does not show the mode: it is in parameterization (IN %1). End that first, with run, then try again.</source>
        <translation>Der Geber zeigt die Betriebsart nicht: Er ist in der Parametrierung (IN %1). Diese erst mit Run beenden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The encoder is in cam mode: there the word %1 %2 (IN %3). Its cam program was changed, and it was left in parameterization: the controller gets no position. Switching the encoder off and on drops the change. Run, or another mode, keeps it: then the cam program has to be written again.</source>
        <translation>Der Geber ist im Nockenbetrieb. Dort gilt: Das Wort %1 %2 (IN %3). Sein Nockenprogramm wurde geändert, und er blieb in der Parametrierung: Die Steuerung bekommt keine Position. Aus- und Einschalten des Gebers verwirft die Änderung. Mit Run oder einer anderen Betriebsart bleibt sie: Dann muss das Nockenprogramm neu geschrieben werden.</translation>
    </message>
    <message>
        <source>%1 does not have all OUT registers of the ring as planned (%2), though it has the first. Compare the bus structure with the ring, and the first register of OUT with the manual of the gateway.</source>
        <translation>%1 hat nicht alle OUT-Register des geplanten Rings (%2), das erste aber doch. Vergleichen Sie den Busaufbau mit dem Ring und das erste Register von OUT mit dem Handbuch des Gateways.</translation>
    </message>
    <message>
        <source>The preset was sent, but it is not known whether the position was set: position mode would show %1, but IN is %2, which may be the speed of velocity mode. Compare the position with the machine, in position mode, before you go on.</source>
        <translation>Der Preset wurde gesendet, aber es ist nicht bekannt, ob die Position gesetzt wurde: Im Positionsbetrieb stünde dort %1, IN ist aber %2, und das kann die Drehzahl des Drehzahlbetriebs sein. Die Position im Positionsbetrieb mit der Maschine vergleichen, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>Error 2: the encoder refused %3, the word for %1 (IN %2). Perhaps it is in cam mode, where it takes no parameters: switch it to position mode, then try again. If it was in position mode, check which encoder it is.</source>
        <translation>Fehler 2: Der Geber hat %3, das Wort für %1, abgelehnt (IN %2). Vielleicht ist er im Nockenbetrieb, in dem er keine Parameter annimmt: in den Positionsbetrieb schalten, dann noch einmal versuchen. War er im Positionsbetrieb, prüfen, welcher Geber es ist.</translation>
    </message>
    <message>
        <source>No answer came from the encoder for %1 s after this was confirmed, so nothing was written. Check the line, then start again.</source>
        <translation>Nach dem Bestätigen kam %1 s lang keine Antwort vom Geber, deshalb wurde nichts geschrieben. Die Leitung prüfen, dann neu beginnen.</translation>
    </message>
    <message>
        <source>The encoder refused the value of %1. Check it and write again.</source>
        <translation>Der Geber hat den Wert für %1 abgelehnt. Wert prüfen und neu schreiben.</translation>
    </message>
    <message>
        <source>The encoder has lost its parameters, and gives no position. Write them again.</source>
        <translation>Der Geber hat seine Parameter verloren und zeigt keine Position. Parameter neu schreiben.</translation>
    </message>
</context>
<context>
    <name>Resolution</name>
    <message>
        <source>%1 mm per step</source>
        <translation>%1 mm je Schritt</translation>
    </message>
</context>
<context>
    <name>RingEdits</name>
    <message>
        <source>A bus terminal belongs on the remote bus.</source>
        <translation>Eine Busklemme gehört an den Fernbus.</translation>
    </message>
    <message>
        <source>A local bus needs a bus terminal.</source>
        <translation>Ein Lokalbus braucht eine Busklemme.</translation>
    </message>
    <message>
        <source>Nothing can hang below %1: it is not a bus terminal.</source>
        <translation>Unter %1 kann nichts hängen: Es ist keine Busklemme.</translation>
    </message>
    <message>
        <source>%1 cannot hang below itself.</source>
        <translation>%1 kann nicht unter sich selbst hängen.</translation>
    </message>
    <message>
        <source>Devices hang below %1, so it has to stay a bus terminal.</source>
        <translation>Unter %1 hängen Teilnehmer, also muss es eine Busklemme bleiben.</translation>
    </message>
</context>
<context>
    <name>RingRules</name>
    <message>
        <source>A ring has at most %1 devices; these are %2.</source>
        <translation>Ein Ring hat höchstens %1 Teilnehmer; hier sind es %2.</translation>
    </message>
    <message>
        <source>The remote bus has at most %1 devices; these are %2.</source>
        <translation>Der Fernbus hat höchstens %1 Teilnehmer; hier sind es %2.</translation>
    </message>
    <message>
        <source>The remote bus has at most %1 levels; these are %2.</source>
        <translation>Der Fernbus hat höchstens %1 Ebenen; hier sind es %2.</translation>
    </message>
    <message>
        <source>A ring has at most %1 inputs; these are %2.</source>
        <translation>Ein Ring hat höchstens %1 Eingänge; hier sind es %2.</translation>
    </message>
    <message>
        <source>A ring has at most %1 outputs; these are %2.</source>
        <translation>Ein Ring hat höchstens %1 Ausgänge; hier sind es %2.</translation>
    </message>
    <message>
        <source>A ring has at most %1 PCP devices; these are %2.</source>
        <translation>Ein Ring hat höchstens %1 PCP-Teilnehmer; hier sind es %2.</translation>
    </message>
    <message>
        <source>A local bus has at most %1 devices; that of segment %3 has %2.</source>
        <translation>Ein Lokalbus hat höchstens %1 Teilnehmer; der von Segment %3 hat %2.</translation>
    </message>
    <message>
        <source>%1 is on a local bus, which needs a bus terminal.</source>
        <translation>%1 ist an einem Lokalbus; dieser braucht eine Busklemme.</translation>
    </message>
    <message>
        <source>%1 is in a branch, which needs a bus terminal.</source>
        <translation>%1 ist in einem Abzweig; dieser braucht eine Busklemme.</translation>
    </message>
    <message>
        <source>%1 is a bus terminal; it belongs on the remote bus.</source>
        <translation>%1 ist eine Busklemme; sie gehört an den Fernbus.</translation>
    </message>
</context>
<context>
    <name>RodPicture</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>steps</source>
        <comment>unit</comment>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>counts up</source>
        <translation>zählt aufwärts</translation>
    </message>
    <message>
        <source>direction not known</source>
        <translation>Zählrichtung unbekannt</translation>
    </message>
</context>
<context>
    <name>RodScale</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Running</source>
        <translation>In Betrieb</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Gesetzt</translation>
    </message>
    <message>
        <source>Inactive</source>
        <translation>Inaktiv</translation>
    </message>
</context>
<context>
    <name>Sequence</name>
    <message>
        <source>Nothing was pasted: line %1, &quot;%2&quot;, is not a hexadecimal word. Each line takes up to 8 digits of 0 to 9 and A to F.</source>
        <translation>Nichts eingefügt: Zeile %1, „%2“, ist kein hexadezimales Wort. Je Zeile bis zu 8 Ziffern 0 bis 9 und A bis F.</translation>
    </message>
    <message>
        <source>There is no word to paste. Copy a column of hexadecimal words first.</source>
        <translation>Es gibt kein Wort zum Einfügen. Erst eine Spalte mit hexadezimalen Worten kopieren.</translation>
    </message>
    <message>
        <source>Nothing was pasted: a sequence has at most %1 words.</source>
        <translation>Nichts eingefügt: Eine Sequenz hat höchstens %1 Worte.</translation>
    </message>
</context>
<context>
    <name>SequenceFile</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>This is not a sequence of words: &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>Das ist keine Sequenz von Worten: „format“ ist nicht „%1“.</translation>
    </message>
    <message>
        <source>Only version %1 of the format can be read.</source>
        <translation>Nur Version %1 des Formats lässt sich lesen.</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>Zeile %1, %2: %3</translation>
    </message>
</context>
<context>
    <name>SerialPortLink</name>
    <message>
        <source>baud rates that the adapter has, 7 or 8 data bits, parity none, even or odd, 1 or 2 stop bits</source>
        <translation>Baudraten, die der Adapter kann, 7 oder 8 Datenbits, Parität keine, gerade oder ungerade, 1 oder 2 Stoppbits</translation>
    </message>
</context>
<context>
    <name>SerialPorts</name>
    <message>
        <source>This computer has no serial port. Plug a USB adapter in, or type the path of a port.</source>
        <translation>Dieser Rechner hat keinen seriellen Anschluss. Einen USB-Adapter einstecken oder den Pfad eines Anschlusses eintippen.</translation>
    </message>
</context>
<context>
    <name>SimulatedEscLine</name>
    <message>
        <source>training line</source>
        <translation>Übungsleitung</translation>
    </message>
</context>
<context>
    <name>SimulatedRing</name>
    <message>
        <source>The training bus is not connected.</source>
        <translation>Der Übungsbus ist nicht verbunden.</translation>
    </message>
    <message>
        <source>The words do not match the devices of the training bus.</source>
        <translation>Die Worte passen nicht zu den Geräten des Übungsbusses.</translation>
    </message>
</context>
<context>
    <name>StructureSteps</name>
    <message>
        <source>Insert %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n devices</source>
        <translation>
            <numerusform>%n Teilnehmer entfernen</numerusform>
            <numerusform>%n Teilnehmer entfernen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n devices</source>
        <translation>
            <numerusform>%n Teilnehmer verschieben</numerusform>
            <numerusform>%n Teilnehmer verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Change %1 to %2</source>
        <translation>%1 in %2 ändern</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>column, device</comment>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>%1 – %2</source>
        <comment>meaning of OUT, meaning of IN</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: confirmed</source>
        <comment>parameter = value</comment>
        <translation>%1: quittiert</translation>
    </message>
    <message>
        <source>%1: not taken yet</source>
        <comment>parameter = value</comment>
        <translation>%1: noch nicht übernommen</translation>
    </message>
    <message>
        <source>%1: not answered</source>
        <comment>meaning of OUT</comment>
        <translation>%1: nicht beantwortet</translation>
    </message>
</context>
<context>
    <name>Traffic</name>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>garbage</source>
        <translation>Störzeichen</translation>
    </message>
    <message>
        <source>late</source>
        <translation>verspätet</translation>
    </message>
</context>
<context>
    <name>TypedRequest</name>
    <message>
        <source>Type a request: two hexadecimal digits for the address, then the command, as in 05P.</source>
        <translation>Eine Anfrage eintippen: zwei Hexziffern für die Adresse, dann der Befehl, wie in 05P.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address. A request begins with two hexadecimal digits: 01 to 1F, or 00 for whichever encoder is alone on the line.</source>
        <translation>„%1“ ist keine Adresse. Eine Anfrage beginnt mit zwei Hexziffern: 01 bis 1F, oder 00 für den Geber, der allein an der Leitung ist.</translation>
    </message>
    <message>
        <source>The command is missing behind the address %1, as in %1P.</source>
        <translation>Hinter der Adresse %1 fehlt der Befehl, wie in %1P.</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. The commands are %2.</source>
        <translation>Es gibt keinen Befehl „%1“. Die Befehle sind %2.</translation>
    </message>
    <message>
        <source>%1 reads (%2) and takes no data: &quot;%3&quot; is too much.</source>
        <translation>%1 liest (%2) und nimmt keine Daten an: „%3“ ist zu viel.</translation>
    </message>
    <message>
        <source>%1 writes (%2) and needs a value behind it, in hexadecimal digits.</source>
        <translation>%1 schreibt (%2) und braucht dahinter einen Wert in Hexziffern.</translation>
    </message>
    <message>
        <source>%1 takes %2 hexadecimal digits at most; these are %3.</source>
        <translation>%1 nimmt höchstens %2 Hexziffern an; hier sind es %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a hexadecimal number.</source>
        <translation>„%1“ ist keine Hexzahl.</translation>
    </message>
    <message>
        <source>%1 is outside of what %2 takes: %3 to %4. All numbers are hexadecimal.</source>
        <translation>%1 liegt außerhalb des Bereichs von %2: %3 bis %4. Alle Zahlen sind hexadezimal.</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>revolution</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>Value</name>
    <message>
        <source>a text of at most %1 characters</source>
        <translation>ein Text mit höchstens %1 Zeichen</translation>
    </message>
</context>
<context>
    <name>ValueNotes</name>
    <message>
        <source>With the steps, the encoder sets its revolutions to %1. To have others, write them along with the steps.</source>
        <translation>Mit den Schritten setzt der Geber seine Umdrehungen auf %1. Sollen es andere sein, diese zusammen mit den Schritten schreiben.</translation>
    </message>
    <message>
        <source>With the steps, the encoder sets its revolutions to %1: now they are %2. To keep them, write them along with the steps.</source>
        <translation>Mit den Schritten setzt der Geber seine Umdrehungen auf %1: Jetzt sind es %2. Sollen sie so bleiben, zusammen mit den Schritten schreiben.</translation>
    </message>
    <message>
        <source>%1 steps in %2 revolutions give no whole number of steps over %3 turns: the position jumps by %5 steps after turn %4.</source>
        <translation>%1 Schritte in %2 Umdrehungen ergeben über %3 Umdrehungen keine ganze Zahl von Schritten: Nach Umdrehung %4 springt die Position um %5 Schritte.</translation>
    </message>
    <message>
        <source>The %1 revolutions do not divide the %2 turns of the encoder: the position jumps by %3 steps after turn %2.</source>
        <translation>Die %1 Umdrehungen teilen die %2 Umdrehungen des Gebers nicht: Nach Umdrehung %2 springt die Position um %3 Schritte.</translation>
    </message>
    <message>
        <source>The measuring range of %1 turns does not divide the %2 turns of the encoder: the position jumps by %3 steps after turn %2.</source>
        <translation>Der Messbereich von %1 Umdrehungen teilt die %2 Umdrehungen des Gebers nicht: Nach Umdrehung %2 springt die Position um %3 Schritte.</translation>
    </message>
    <message>
        <source>The measuring range of %1 turns does not divide the %2 turns of the encoder: the position jumps after turn %2.</source>
        <translation>Der Messbereich von %1 Umdrehungen teilt die %2 Umdrehungen des Gebers nicht: Nach Umdrehung %2 springt die Position.</translation>
    </message>
    <message>
        <source>%1 steps in %2 revolutions give no whole number of steps over %3 turns: the position jumps by a fraction of a step after turn %4.</source>
        <translation>%1 Schritte in %2 Umdrehungen ergeben über %3 Umdrehungen keine ganze Zahl von Schritten: Nach Umdrehung %4 springt die Position um den Bruchteil eines Schritts.</translation>
    </message>
    <message>
        <source>With another scaling the position tells another place: set it to the preset again afterwards.</source>
        <translation>Mit einer anderen Skalierung steht derselbe Zahlenwert für einen anderen Ort: Die Position danach wieder auf den Preset setzen.</translation>
    </message>
    <message>
        <source>Scaling is off: the encoder keeps the values that scale its position, but counts its own steps until scaling is on.</source>
        <translation>Die Skalierung ist aus: Der Geber behält die Werte, die seine Position skalieren, zählt aber seine eigenen Schritte, bis die Skalierung ein ist.</translation>
    </message>
    <message>
        <source>It is not known whether scaling is on: while it is off, the encoder keeps the values that scale its position, but counts its own steps.</source>
        <translation>Ob die Skalierung ein ist, ist nicht bekannt: Solange sie aus ist, behält der Geber die Werte, die seine Position skalieren, zählt aber seine eigenen Schritte.</translation>
    </message>
    <message>
        <source>Setting the position makes a new zero offset: the wanted one, %1, is left out.</source>
        <translation>Das Setzen der Position ergibt eine neue Nullpunkt-Verschiebung: Die gewünschte, %1, entfällt.</translation>
    </message>
    <message>
        <source>This shifts the position, by how much is not known.</source>
        <translation>Das verschiebt die Position; um wie viel, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>This shifts the position: now %1, then %2.</source>
        <translation>Das verschiebt die Position: jetzt %1, danach %2.</translation>
    </message>
    <message>
        <source>This shifts the position: now %1, then about %2.</source>
        <translation>Das verschiebt die Position: jetzt %1, danach etwa %2.</translation>
    </message>
    <message>
        <source>A preset acts once, and the one in the encoder is used up: it is written again, so that the position can be set to it.</source>
        <translation>Ein Preset wirkt einmal, und der im Geber ist verbraucht: Er wird noch einmal geschrieben, damit die Position darauf gesetzt werden kann.</translation>
    </message>
    <message>
        <source>A preset acts once. Whether the one in the encoder is used up is read first; if it is, it is written again.</source>
        <translation>Ein Preset wirkt einmal. Ob der im Geber verbraucht ist, wird zuerst ausgelesen; wenn ja, wird er noch einmal geschrieben.</translation>
    </message>
    <message>
        <source>Perhaps not in force</source>
        <translation>Vielleicht nicht wirksam</translation>
    </message>
    <message>
        <source>Not in force</source>
        <translation>Nicht wirksam</translation>
    </message>
</context>
<context>
    <name>WizardReport</name>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht abgeschlossen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>OUT</source>
        <translation>OUT</translation>
    </message>
    <message>
        <source>IN</source>
        <translation>IN</translation>
    </message>
    <message>
        <source>OUT means</source>
        <translation>OUT bedeutet</translation>
    </message>
    <message>
        <source>IN means</source>
        <translation>IN bedeutet</translation>
    </message>
    <message>
        <source>Parameterization of encoder %1</source>
        <translation>Parametrierung des Gebers %1</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Brought back</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>Position before</source>
        <translation>Position vorher</translation>
    </message>
    <message>
        <source>Position after</source>
        <translation>Position nachher</translation>
    </message>
    <message>
        <source>EEPROM writes</source>
        <translation>EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>%1 by this handshake, %2 by this program since it was connected</source>
        <translation>%1 durch diesen Handshake, %2 durch dieses Programm seit dem Verbinden</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>no: the handshake did not end well</source>
        <translation>nein: Der Handshake ist gescheitert</translation>
    </message>
    <message>
        <source>read back from the encoder, and equal</source>
        <translation>aus dem Geber zurückgelesen, stimmt überein</translation>
    </message>
    <message>
        <source>confirmed in the handshake, and run was answered by operation; this encoder cannot be read</source>
        <translation>im Handshake quittiert, und auf Run folgte der Betrieb; dieser Geber lässt sich nicht auslesen</translation>
    </message>
    <message>
        <source>Position set to</source>
        <translation>Position gesetzt auf</translation>
    </message>
    <message>
        <source>Restored</source>
        <translation>Wiederhergestellt</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Nicht bekannt</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source>the encoder shows the position that was set</source>
        <translation>der Geber zeigt die gesetzte Position</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Entfällt</translation>
    </message>
    <message>
        <source>Position to be set</source>
        <translation>Zu setzende Position</translation>
    </message>
    <message>
        <source>Position set by the preset</source>
        <translation>Position gesetzt nach dem Preset</translation>
    </message>
    <message>
        <source>Preset to set the position by</source>
        <translation>Preset, nach dem die Position zu setzen ist</translation>
    </message>
    <message>
        <source>State at the end of the handshake</source>
        <translation>Zustand am Ende des Handshakes</translation>
    </message>
    <message>
        <source>Mode afterwards</source>
        <translation>Betriebsart danach</translation>
    </message>
    <message>
        <source>confirmed by the encoder, which cannot be read</source>
        <translation>vom Geber quittiert, der sich nicht auslesen lässt</translation>
    </message>
    <message>
        <source>no: the handshake was cancelled</source>
        <translation>nein: Der Handshake wurde abgebrochen</translation>
    </message>
</context>
<context>
    <name>WordFormat</name>
    <message>
        <source>There is no word here. Type up to 8 hexadecimal digits, such as 020000FF.</source>
        <translation>Hier steht kein Wort. Bis zu 8 Hexziffern eingeben, etwa 020000FF.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a hexadecimal word. Type up to 8 of the digits 0 to 9 and A to F, such as 020000FF.</source>
        <translation>„%1“ ist kein hexadezimales Wort. Bis zu 8 Ziffern 0 bis 9 und A bis F eingeben, etwa 020000FF.</translation>
    </message>
</context>
<context>
    <name>WriteConsequence</name>
    <message>
        <source>The position becomes this value at once.</source>
        <translation>Die Position nimmt sofort diesen Wert an.</translation>
    </message>
    <message>
        <source>The position may count the other way and jump.</source>
        <translation>Die Position kann andersherum zählen und springen.</translation>
    </message>
    <message>
        <source>The position may jump.</source>
        <translation>Die Position kann springen.</translation>
    </message>
    <message>
        <source>The limit switch may change its state.</source>
        <translation>Der Endschalter kann seinen Zustand ändern.</translation>
    </message>
    <message>
        <source>The encoder answers at the new address from then on.</source>
        <translation>Der Geber antwortet ab dann unter der neuen Adresse.</translation>
    </message>
    <message>
        <source>The encoder answers at the new baud rate from then on.</source>
        <translation>Der Geber antwortet ab dann mit der neuen Baudrate.</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>These bytes are sent once: %1.</source>
        <translation>Diese Bytes werden einmal gesendet: %1.</translation>
    </message>
    <message>
        <source>The address 00 is that of every encoder: all on the line take it.</source>
        <translation>Die Adresse 00 gilt für jeden Geber: Alle an der Leitung übernehmen den Wert.</translation>
    </message>
    <message>
        <source>It costs one EEPROM write.</source>
        <translation>Das kostet einen EEPROM-Schreibvorgang.</translation>
    </message>
</context>
<context>
    <name>codewheel</name>
    <message>
        <source>Sets up, watches and diagnoses absolute encoders on INTERBUS and on serial lines.</source>
        <translation>Richtet Absolutgeber am INTERBUS und an seriellen Leitungen ein, beobachtet sie und findet Fehler.</translation>
    </message>
    <message>
        <source>Standard output cannot be written: %1.</source>
        <translation>Auf die Standardausgabe kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>A project to open: *.codewheel, a recording: *.cwrec, cams: *.cwcams, a fault plan: *.cwfaults, or a device description or sequence: *.json</source>
        <translation>Ein Projekt, das geöffnet werden soll: *.codewheel, eine Aufzeichnung: *.cwrec, Nocken: *.cwcams, ein Fehlerplan: *.cwfaults oder eine Gerätebeschreibung oder Sequenz: *.json</translation>
    </message>
</context>
<context>
    <name>codewheel::AccountView</name>
    <message>
        <source>C&amp;opy</source>
        <translation>K&amp;opieren</translation>
    </message>
    <message>
        <source>What was written where</source>
        <translation>Was wohin geschrieben wurde</translation>
    </message>
    <message>
        <source>What became of each value</source>
        <translation>Was aus jedem Wert wurde</translation>
    </message>
    <message>
        <source>As plain text, or as a web page if the name ends in .html</source>
        <translation>Als Text, oder als Webseite, wenn der Name auf .html endet</translation>
    </message>
    <message>
        <source>Copies the text</source>
        <translation>Kopiert den Text</translation>
    </message>
    <message>
        <source>Save what was written where</source>
        <translation>Speichern, was wohin geschrieben wurde</translation>
    </message>
    <message>
        <source>Text (*.txt);;Web page (*.html)</source>
        <translation>Text (*.txt);;Webseite (*.html)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>%1 was not saved: %2. Choose another place.</source>
        <translation>%1 wurde nicht gespeichert: %2. Einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Kopiert.</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
</context>
<context>
    <name>codewheel::Afresh</name>
    <message>
        <source>It is not connected. Connect it first.</source>
        <translation>Es besteht keine Verbindung. Zuerst verbinden.</translation>
    </message>
    <message>
        <source>It is real: only what is simulated can start afresh.</source>
        <translation>Er ist echt: Nur Simuliertes kann neu beginnen.</translation>
    </message>
    <message>
        <source>Everything simulated is as at the start: no faults, factory values, shafts where they were. What was known of the encoders is forgotten</source>
        <translation>Alles Simulierte ist wie am Anfang: keine Störungen, Werkseinstellungen, Wellen wo sie waren. Was von den Gebern bekannt war, ist vergessen</translation>
    </message>
</context>
<context>
    <name>codewheel::BarView</name>
    <message>
        <source>%1 bar</source>
        <comment>IN 1.0 bar</comment>
        <translation>Balken %1</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>%1 of %2 to %3</source>
        <comment>value, range</comment>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1, not up to date</source>
        <comment>value of range</comment>
        <translation>%1, nicht aktuell</translation>
    </message>
</context>
<context>
    <name>codewheel::BusBranch</name>
    <message>
        <source>%1: %2</source>
        <comment>station, device</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>other kind</source>
        <comment>of device than planned</comment>
        <translation>andere Art</translation>
    </message>
</context>
<context>
    <name>codewheel::BusFaults</name>
    <message>
        <source>The fault is not told any more, but the bus is stopped. Start it again.</source>
        <translation>Die Störung wird nicht mehr gemeldet, aber der Bus ist angehalten. Neu starten.</translation>
    </message>
</context>
<context>
    <name>codewheel::BusList</name>
    <message>
        <source>Buses of the project</source>
        <translation>Busse des Projekts</translation>
    </message>
    <message>
        <source>The buses that are planned, each with its devices. Insert adds one, Delete removes one, F2 renames one.</source>
        <translation>Die geplanten Busse, jeder mit seinen Teilnehmern. Einfg plant einen weiteren, Entf entfernt einen, F2 benennt einen um.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Plan another bus</source>
        <translation>Weiteren Bus planen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the bus from the project with its devices; what is connected is not touched</source>
        <translation>Den Bus mit seinen Teilnehmern aus dem Projekt entfernen; was verbunden ist, bleibt unberührt</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give the bus another name</source>
        <translation>Den Bus umbenennen</translation>
    </message>
    <message>
        <source>Kinds of buses</source>
        <translation>Arten von Bussen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>All that is planned and known of the %n devices of &quot;%1&quot; leaves the project with it. What is connected is not touched.</source>
        <translation>
            <numerusform>Mit „%1“ wird alles aus dem Projekt entfernt, was von seinem %n Teilnehmer geplant und bekannt ist. Was verbunden ist, bleibt unberührt.</numerusform>
            <numerusform>Mit „%1“ wird alles aus dem Projekt entfernt, was von seinen %n Teilnehmern geplant und bekannt ist. Was verbunden ist, bleibt unberührt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Remove &quot;%1&quot; and its %n devices</source>
        <translation>
            <numerusform>„%1“ und seinen %n Teilnehmer ent&amp;fernen</numerusform>
            <numerusform>„%1“ und seine %n Teilnehmer ent&amp;fernen</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Until its connection leads to a real bus, &quot;%1&quot; is simulated: it is that of the training bus, and what is connected there stays connected.</source>
        <translation>Bis seine Verbindung zu einem echten Bus führt, ist „%1“ simuliert: Es ist der des Übungsbusses, und was dort verbunden ist, bleibt verbunden.</translation>
    </message>
</context>
<context>
    <name>codewheel::BusModel</name>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Teilnehmer</translation>
    </message>
    <message>
        <source>%1: F2 or a double click renames it</source>
        <translation>%1: F2 oder ein Doppelklick benennt ihn um</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>A bus needs a name: type one. Esc gives back the previous name.</source>
        <translation>Ein Bus braucht einen Namen: einen eingeben. Esc stellt den vorigen wieder her.</translation>
    </message>
    <message>
        <source>The name of a bus has no &quot;/&quot;, which separates it from the place of a device.</source>
        <translation>Der Name eines Busses darf kein „/“ enthalten: Es steht zwischen ihm und dem Platz eines Teilnehmers.</translation>
    </message>
    <message>
        <source>Another bus is called &quot;%1&quot;: a name can be used only once in a project.</source>
        <translation>Ein anderer Bus heißt schon „%1“: Jeder Name kann in einem Projekt nur einmal vorkommen.</translation>
    </message>
</context>
<context>
    <name>codewheel::BusOutline</name>
    <message>
        <source>offline</source>
        <translation>offline</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>wird verbunden</translation>
    </message>
    <message>
        <source>jobs end</source>
        <translation>Aufträge enden noch</translation>
    </message>
</context>
<context>
    <name>codewheel::CamBoard</name>
    <message>
        <source>Scroll the ruler</source>
        <translation>Das Lineal verschieben</translation>
    </message>
    <message>
        <source>Zoom in (+)</source>
        <translation>Vergrößern (+)</translation>
    </message>
    <message>
        <source>Zoom out (-)</source>
        <translation>Verkleinern (-)</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Show all positions (0)</source>
        <translation>Alle Positionen zeigen (0)</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>Ver&amp;schiebung</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 bis %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Shift</source>
        <comment>of the position</comment>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>What IN will hold</source>
        <translation>Was in IN steht</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Which part of the positions is visible</source>
        <translation>Welcher Teil der Positionen zu sehen ist</translation>
    </message>
</context>
<context>
    <name>codewheel::CamDelegate</name>
    <message>
        <source>Start of cam %1</source>
        <translation>Anfang von Nocken %1</translation>
    </message>
    <message>
        <source>Stop of cam %1</source>
        <translation>Ende von Nocken %1</translation>
    </message>
    <message>
        <source>A position from 0 to %1; decimal, or hexadecimal as 0x.. or ..h</source>
        <translation>Eine Position von 0 bis %1; dezimal oder hexadezimal als 0x.. oder ..h</translation>
    </message>
    <message>
        <source>Hysteresis of cam %1</source>
        <translation>Hysterese von Nocken %1</translation>
    </message>
</context>
<context>
    <name>codewheel::CamDocument</name>
    <message>
        <source>Program %1: %2</source>
        <translation>Programm %1: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what was done, at which encoder</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>codewheel::CamEditor</name>
    <message>
        <source>No encoder is chosen</source>
        <translation>Kein Geber gewählt</translation>
    </message>
    <message>
        <source>Choose an encoder with cams, such as the FRABA OCD-IB K3, in the bus structure. Its eight programs of eight cams are edited here.</source>
        <translation>Im Busaufbau einen Geber mit Nocken wählen, etwa den FRABA OCD-IB K3. Hier werden seine acht Programme mit je acht Nocken bearbeitet.</translation>
    </message>
    <message>
        <source>Program %1 runs in the encoder. &quot;Now&quot; is what it shows.</source>
        <translation>Programm %1 läuft im Geber. „Jetzt“ ist, was er zeigt.</translation>
    </message>
    <message>
        <source>&quot;Now&quot; is what the cams of program %1 would be.</source>
        <translation>„Jetzt“ ist, wie die Nocken von Programm %1 stünden.</translation>
    </message>
    <message>
        <source>What its cams would be is not known.</source>
        <translation>Wie seine Nocken stünden, ist unbekannt.</translation>
    </message>
    <message>
        <source>Program %1 runs in the encoder.</source>
        <translation>Programm %1 läuft im Geber.</translation>
    </message>
    <message>
        <source>The encoder is in cam mode; which program runs is not known.</source>
        <translation>Der Geber ist im Nockenbetrieb; welches Programm läuft, ist unbekannt.</translation>
    </message>
    <message>
        <source>The encoder shows no cams now.</source>
        <translation>Der Geber zeigt jetzt keine Nocken.</translation>
    </message>
    <message>
        <source>The mode of the encoder is not known, and so are its cams.</source>
        <translation>Die Betriebsart des Gebers ist unbekannt, und damit auch seine Nocken.</translation>
    </message>
    <message>
        <source>The encoder is in velocity mode and shows no cams.</source>
        <translation>Der Geber ist im Drehzahlbetrieb und zeigt keine Nocken.</translation>
    </message>
    <message>
        <source>The encoder is in position mode.</source>
        <translation>Der Geber ist im Positionsbetrieb.</translation>
    </message>
    <message>
        <source>No program has to be written: none is set that the encoder does not have.</source>
        <translation>Es muss kein Programm geschrieben werden: Alle hier gesetzten stehen schon im Geber.</translation>
    </message>
    <message>
        <source>Program %1: %2</source>
        <translation>Programm %1: %2</translation>
    </message>
    <message>
        <source>Read from the encoder</source>
        <translation>Aus dem Geber ausgelesen</translation>
    </message>
    <message>
        <source>The encoder has the same program %1.</source>
        <translation>Im Geber steht dasselbe Programm %1.</translation>
    </message>
    <message>
        <source>The lines in the ruler show what the encoder has. Nothing was changed.</source>
        <translation>Die Linien im Lineal zeigen den Stand im Geber. Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Open cam programs</source>
        <translation>Nockenprogramme öffnen</translation>
    </message>
    <message>
        <source>Open cam program %1</source>
        <translation>Nockenprogramm %1 öffnen</translation>
    </message>
    <message>
        <source>Save all cam programs</source>
        <translation>Alle Nockenprogramme speichern</translation>
    </message>
    <message>
        <source>Save cam program %1</source>
        <translation>Nockenprogramm %1 speichern</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Auslesen</translation>
    </message>
    <message>
        <source>Show what will be written before anything is sent</source>
        <translation>Zeigen, was geschrieben wird, bevor etwas gesendet wird</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Read this program and say what differs; nothing is changed</source>
        <translation>Dieses Programm auslesen und Abweichungen anzeigen; geändert wird nichts</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>&amp;Run this program in the encoder</source>
        <translation>Dieses Programm im Geber a&amp;usführen</translation>
    </message>
    <message>
        <source>Cam mode: IN shows the cams of this program</source>
        <translation>Nockenbetrieb: IN zeigt die Nocken dieses Programms</translation>
    </message>
    <message>
        <source>Back to &amp;position mode</source>
        <translation>Zurück in den &amp;Positionsbetrieb</translation>
    </message>
    <message>
        <source>IN shows the position again</source>
        <translation>IN zeigt wieder die Position</translation>
    </message>
    <message>
        <source>Read &amp;all programs</source>
        <translation>&amp;Alle Programme auslesen</translation>
    </message>
    <message>
        <source>Each program is left again: what was changed and not stored is stored then, up to 8 EEPROM writes</source>
        <translation>Jedes Programm wird wieder verlassen: Was geändert, aber nicht gespeichert war, wird dabei gespeichert; bis zu 8 EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>All that are set here and are not known to be in the encoder</source>
        <translation>Alle, die hier gesetzt sind und von denen nicht bekannt ist, dass sie im Geber stehen</translation>
    </message>
    <message>
        <source>&amp;Clear this program</source>
        <translation>Dieses Programm &amp;leeren</translation>
    </message>
    <message>
        <source>All eight cams inactive, shift 0; can be undone</source>
        <translation>Alle acht Nocken inaktiv, Verschiebung 0; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>Modes, all programs, single files</source>
        <translation>Betriebsarten, alle Programme, einzelne Dateien</translation>
    </message>
    <message>
        <source>More for the cams</source>
        <translation>Mehr zu den Nocken</translation>
    </message>
    <message>
        <source>Clear program %1</source>
        <translation>Programm %1 leeren</translation>
    </message>
    <message>
        <source>Not connected: what the encoder has and shows is not known. The cams are kept in the project.</source>
        <translation>Nicht verbunden: Was der Geber hat und zeigt, ist unbekannt. Die Nocken bleiben im Projekt.</translation>
    </message>
    <message>
        <source>Not connected: nothing can be read or written.</source>
        <translation>Nicht verbunden: Nichts lässt sich lesen oder schreiben.</translation>
    </message>
    <message>
        <source>The largest position cannot be %1: the encoder shows %2.</source>
        <translation>Die größte Position kann nicht %1 sein: Der Geber zeigt %2.</translation>
    </message>
    <message>
        <source>Not up to date: %1</source>
        <comment>a sentence</comment>
        <translation>Nicht aktuell: %1</translation>
    </message>
    <message>
        <source>The encoder has all of it already. Nothing was written.</source>
        <translation>Im Geber steht das alles schon. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>cam %1</source>
        <translation>Nocken %1</translation>
    </message>
    <message>
        <source>the shift (the encoder has %1)</source>
        <translation>Verschiebung (im Geber %1)</translation>
    </message>
    <message>
        <source>Program %1 differs in: %2.</source>
        <translation>Programm %1 weicht ab in: %2.</translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht gespeichert: %2</translation>
    </message>
    <message>
        <source>Edits cam programs of the project; only Read, Write and Compare send.</source>
        <translation>Bearbeitet Nocken; nur Auslesen, Schreiben und Vergleichen senden.</translation>
    </message>
    <message>
        <source>Edits cam programs of the project. Nothing is sent here.</source>
        <translation>Bearbeitet Nockenprogramme des Projekts. Hier wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Cams</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>Loaded from %1: program %2.</source>
        <translation>Aus %1 übernommen: Programm %2.</translation>
    </message>
    <message>
        <source>Read this program from the encoder; no position is shown meanwhile</source>
        <translation>Dieses Programm aus dem Geber auslesen; solange fehlt die Position</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Schreiben…</translation>
    </message>
    <message>
        <source>Load the cam programs from a file</source>
        <translation>Die Nockenprogramme einer Datei übernehmen</translation>
    </message>
    <message>
        <source>&amp;Write all programs…</source>
        <translation>Alle Programme &amp;schreiben…</translation>
    </message>
    <message>
        <source>&amp;Open this program alone…</source>
        <translation>Nur dieses Programm ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Load the program shown from a file</source>
        <translation>Das gezeigte Programm aus einer Datei übernehmen</translation>
    </message>
    <message>
        <source>&amp;Save this program alone…</source>
        <translation>Nur dieses Programm spei&amp;chern…</translation>
    </message>
    <message>
        <source>Save the program shown in a file</source>
        <translation>Das gezeigte Programm in einer Datei speichern</translation>
    </message>
    <message>
        <source>Save all eight programs in a file of their own</source>
        <translation>Alle acht Programme in einer eigenen Datei ablegen</translation>
    </message>
    <message>
        <source>Show this cam in &amp;trend</source>
        <translation>Diesen Nocken im &amp;Trend zeigen</translation>
    </message>
    <message>
        <source>As it is in IN while the encoder is in cam mode</source>
        <translation>Wie er in IN steht, solange der Geber im Nockenbetrieb ist</translation>
    </message>
    <message>
        <source>Cam programs (*.cwcams *.json)</source>
        <translation>Nockenprogramme (*.cwcams *.json)</translation>
    </message>
    <message>
        <source>cams.cwcams</source>
        <translation>nocken.cwcams</translation>
    </message>
    <message>
        <source>cams-%1.cwcams</source>
        <comment>file name</comment>
        <translation>nocken-%1.cwcams</translation>
    </message>
</context>
<context>
    <name>codewheel::CamFileReader</name>
    <message>
        <source>This is not a file of cam programs: the format is not &quot;%1&quot;.</source>
        <translation>Dies ist keine Datei mit Nockenprogrammen: Das Format ist nicht „%1“.</translation>
    </message>
    <message>
        <source>Only version %1 of the format can be read.</source>
        <translation>Nur Version %1 des Formats ist lesbar.</translation>
    </message>
    <message>
        <source>At least one cam program is expected here.</source>
        <translation>Hier wird mindestens ein Nockenprogramm erwartet.</translation>
    </message>
    <message>
        <source>Cam program %1 is already given above.</source>
        <translation>Nockenprogramm %1 steht schon weiter oben.</translation>
    </message>
    <message>
        <source>Cam %1 is already given above.</source>
        <translation>Nocken %1 steht schon weiter oben.</translation>
    </message>
    <message>
        <source>%1 contains cam programs for the device %2; this encoder is %3. Nothing was taken from the file.</source>
        <translation>%1 enthält Nockenprogramme für das Gerät %2; dieser Geber ist %3. Aus der Datei wurde nichts übernommen.</translation>
    </message>
</context>
<context>
    <name>codewheel::CamModeBar</name>
    <message>
        <source>The mode of the encoder is not known, and for this it is switched to cam mode. Which mode should it be in afterwards?</source>
        <translation>Die Betriebsart des Gebers ist unbekannt; hierfür wird er in den Nockenbetrieb geschaltet. In welcher Betriebsart soll er danach sein?</translation>
    </message>
    <message>
        <source>&amp;Position mode</source>
        <translation>&amp;Positionsbetrieb</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>IN shows the position again (20800000)</source>
        <translation>IN zeigt wieder die Position (20800000)</translation>
    </message>
    <message>
        <source>IN goes on showing the cams</source>
        <translation>IN zeigt weiter die Nocken</translation>
    </message>
    <message>
        <source>Nothing is sent (Esc)</source>
        <translation>Gesendet wird nichts (Esc)</translation>
    </message>
    <message>
        <source>Cam &amp;mode, program %1</source>
        <translation>&amp;Nockenbetrieb, Programm %1</translation>
    </message>
    <message>
        <source>Cam mode</source>
        <translation>Nockenbetrieb</translation>
    </message>
</context>
<context>
    <name>codewheel::CamProgramButton</name>
    <message>
        <source>Cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>What the encoder has is not known.</source>
        <translation>Der Stand im Geber ist unbekannt.</translation>
    </message>
    <message>
        <source>The encoder has another program.</source>
        <translation>Im Geber steht ein anderes Programm.</translation>
    </message>
    <message>
        <source>The encoder has the same.</source>
        <translation>Im Geber steht dasselbe.</translation>
    </message>
    <message>
        <source>%1 of %2 cams are active.</source>
        <translation>%1 von %2 Nocken sind aktiv.</translation>
    </message>
    <message>
        <source>The encoder had another program.</source>
        <translation>Im Geber stand ein anderes Programm.</translation>
    </message>
    <message>
        <source>The encoder had the same.</source>
        <translation>Im Geber stand dasselbe.</translation>
    </message>
</context>
<context>
    <name>codewheel::CamProgramStrip</name>
    <message>
        <source>Cam programs</source>
        <translation>Nockenprogramme</translation>
    </message>
    <message>
        <source>Opens the program with this number</source>
        <translation>Öffnet das Programm mit dieser Nummer</translation>
    </message>
</context>
<context>
    <name>codewheel::CamRangeBar</name>
    <message>
        <source>The largest position cannot be %1. Give a number from 1 to %2.</source>
        <translation>Die größte Position kann nicht %1 sein. Eine Zahl von 1 bis %2 angeben.</translation>
    </message>
    <message>
        <source>Read &amp;it</source>
        <translation>A&amp;uslesen</translation>
    </message>
    <message>
        <source>Largest position</source>
        <translation>Größte Position</translation>
    </message>
    <message>
        <source>largest position</source>
        <translation>größte Position</translation>
    </message>
    <message>
        <source>Total range - 1, from the encoder&apos;s papers; decimal, or hexadecimal as 0x.. or ..h</source>
        <translation>Gesamtbereich - 1, aus den Unterlagen des Gebers; dezimal oder hexadezimal als 0x.. oder ..h</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Reads steps and revolutions. That sends words, and hides the position for some cycles.</source>
        <translation>Liest Schritte und Umdrehungen. Das sendet Worte; die Position fehlt für einige Zyklen.</translation>
    </message>
    <message>
        <source>Uses the largest position as given; nothing is sent</source>
        <translation>Übernimmt die eingegebene größte Position; gesendet wird nichts</translation>
    </message>
    <message>
        <source>The positions go up to %1, set manually; the encoder was not asked.</source>
        <translation>Die Positionen gehen bis %1, von Hand eingetragen; der Geber wurde nicht gefragt.</translation>
    </message>
    <message>
        <source>The number of positions is not known.</source>
        <translation>Wie viele Positionen es gibt, ist unbekannt.</translation>
    </message>
</context>
<context>
    <name>codewheel::CamReview</name>
    <message>
        <source>A&amp;fterwards the encoder is in</source>
        <translation>&amp;Danach ist der Geber im</translation>
    </message>
    <message>
        <source>Mode afterwards</source>
        <translation>Betriebsart danach</translation>
    </message>
    <message>
        <source>Write cam program %1 to the encoder at %2</source>
        <translation>Nockenprogramm %1 in den Geber bei %2 schreiben</translation>
    </message>
    <message>
        <source>Write %1 cam programs to the encoder at %2</source>
        <translation>%1 Nockenprogramme in den Geber bei %2 schreiben</translation>
    </message>
    <message>
        <source>&amp;Write this word</source>
        <translation>Dieses &amp;Wort schreiben</translation>
    </message>
    <message>
        <source>&amp;Write these %1 words</source>
        <translation>Diese %1 &amp;Worte schreiben</translation>
    </message>
    <message>
        <source>The encoder is known to have all of it. There is nothing to write.</source>
        <translation>Das alles steht schon im Geber. Es gibt nichts zu schreiben.</translation>
    </message>
    <message>
        <source>Sends these words in this order, and reads before and after</source>
        <translation>Sendet diese Worte in dieser Reihenfolge und liest davor und danach</translation>
    </message>
    <message>
        <source>Not listed are the words that read: 2020.... and the 00000000 behind each.</source>
        <translation>Nicht aufgeführt sind die Worte zum Lesen: 2020.... und jeweils 00000000 danach.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Encoder has</source>
        <translation>Im Geber</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>A program that is changed is stored in EEPROM when it is left: one write.</source>
        <translation>Ein Programm, das geändert wurde, wird im EEPROM gespeichert, wenn es verlassen wird: ein Schreibvorgang.</translation>
    </message>
    <message>
        <source>Cams are written in cam mode: no position is shown meanwhile. A program is stored in EEPROM when it is left.</source>
        <translation>Nocken werden im Nockenbetrieb geschrieben: Solange fehlt die Position. Ein Programm wird im EEPROM gespeichert, wenn es verlassen wird.</translation>
    </message>
    <message>
        <source>Sent although already there: %1. Outside cam mode the word after it would mean something else.</source>
        <translation>Wird gesendet, obwohl es schon gilt: %1. Außerhalb des Nockenbetriebs hätte das Wort danach eine andere Bedeutung.</translation>
    </message>
    <message>
        <source>The encoder had all of it when it was seen last. Whether it has it now is not known: %1</source>
        <comment>a sentence</comment>
        <translation>Als der Geber zuletzt zu sehen war, hatte er alles schon. Ob er es jetzt hat, ist nicht bekannt: %1</translation>
    </message>
</context>
<context>
    <name>codewheel::CamRuler</name>
    <message>
        <source>Ruler of the cams</source>
        <translation>Lineal der Nocken</translation>
    </message>
    <message>
        <source>Draw cam %1</source>
        <translation>Nocken %1 zeichnen</translation>
    </message>
    <message>
        <source>Drag to draw cam %1</source>
        <translation>Ziehen zeichnet Nocken %1</translation>
    </message>
    <message>
        <source>Moves the cam or its edge by one step</source>
        <translation>Verschiebt den Nocken oder seine Kante um einen Schritt</translation>
    </message>
    <message>
        <source>Moves it to the next line of the ruler</source>
        <translation>Verschiebt ihn zum nächsten Strich des Lineals</translation>
    </message>
    <message>
        <source>Takes the first or the last position of the cam</source>
        <translation>Fasst die erste oder die letzte Position des Nockens</translation>
    </message>
    <message>
        <source>To another cam</source>
        <translation>Zu einem anderen Nocken</translation>
    </message>
    <message>
        <source>Switches what has the focus on or off</source>
        <translation>Schaltet ein oder aus, was den Fokus hat</translation>
    </message>
    <message>
        <source>Clears the cam</source>
        <translation>Löscht den Nocken</translation>
    </message>
    <message>
        <source>Back to the whole cam</source>
        <translation>Zurück zum ganzen Nocken</translation>
    </message>
    <message>
        <source>Shows fewer positions, or more, or all</source>
        <translation>Zeigt weniger Positionen, mehr oder alle</translation>
    </message>
</context>
<context>
    <name>codewheel::CamSheet</name>
    <message>
        <source>Activate cam %1</source>
        <translation>Nocken %1 aktivieren</translation>
    </message>
    <message>
        <source>Deactivate cam %1</source>
        <translation>Nocken %1 deaktivieren</translation>
    </message>
    <message>
        <source>Clear cam %1</source>
        <translation>Nocken %1 leeren</translation>
    </message>
    <message>
        <source>Shift the position</source>
        <translation>Die Position verschieben</translation>
    </message>
</context>
<context>
    <name>codewheel::CamShiftSpin</name>
    <message>
        <source>Shift of the position</source>
        <translation>Verschiebung der Position</translation>
    </message>
    <message>
        <source>shift_iw: by how many bits the position is shifted right before it stands in D24 to D8. 25 shows the cams only.</source>
        <translation>shift_iw: um wie viele Bits die Position nach rechts verschoben wird, ehe sie in D24 bis D8 steht. 25 zeigt nur die Nocken.</translation>
    </message>
</context>
<context>
    <name>codewheel::CamTable</name>
    <message>
        <source>Cams of the program</source>
        <translation>Nocken des Programms</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Edits a position; so does typing</source>
        <translation>Bearbeitet eine Position; Tippen ebenso</translation>
    </message>
    <message>
        <source>Switches the cam on or off</source>
        <translation>Schaltet den Nocken ein oder aus</translation>
    </message>
    <message>
        <source>Clears the cam</source>
        <translation>Löscht den Nocken</translation>
    </message>
</context>
<context>
    <name>codewheel::CamTableModel</name>
    <message>
        <source>Ticked: the cam is active. Only active cams come on.</source>
        <translation>Angehakt: Der Nocken ist aktiv. Nur aktive Nocken schalten ein.</translation>
    </message>
    <message>
        <source>Cam</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>First position on which the cam is on, in steps</source>
        <translation>Erste Position, auf der der Nocken ein ist, in Schritten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Last position on which the cam is on, in steps; smaller than the start: through zero</source>
        <translation>Letzte Position, auf der der Nocken ein ist, in Schritten; kleiner als der Anfang: über null</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>What the encoder shows now in cam mode; in position mode, what these cams would be</source>
        <translation>Was der Geber im Nockenbetrieb jetzt zeigt; im Positionsbetrieb, wie diese Nocken stünden</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Whether the encoder is known to have the same</source>
        <translation>Ob der Geber nach dem, was bekannt ist, dasselbe hat</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>Polarity of cam %1</source>
        <translation>Polarität von Nocken %1</translation>
    </message>
    <message>
        <source>Hysteresis of cam %1</source>
        <translation>Hysterese von Nocken %1</translation>
    </message>
    <message>
        <source>Steps behind an edge until the cam goes back</source>
        <translation>Schritte hinter einer Schaltflanke, bis der Nocken zurückschaltet</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>Ticked: the cam is on outside of its positions</source>
        <translation>Angehakt: Außerhalb seiner Positionen ist der Nocken ein</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>%1, not up to date</source>
        <translation>%1, nicht aktuell</translation>
    </message>
</context>
<context>
    <name>codewheel::CamWordPicture</name>
    <message>
        <source>What IN will hold</source>
        <translation>Was in IN steht</translation>
    </message>
    <message>
        <source>D7 to D0: cams 7 to 0. No part of the position. D31: not valid.</source>
        <translation>D7 bis D0: Nocken 7 bis 0. Kein Teil der Position. D31: nicht gültig.</translation>
    </message>
    <message>
        <source>D24 to D8: bits %1 to %2 of the position. D7 to D0: cams 7 to 0. D31: not valid.</source>
        <translation>D24 bis D8: Bits %1 bis %2 der Position. D7 bis D0: Nocken 7 bis 0. D31: nicht gültig.</translation>
    </message>
    <message>
        <source>! not valid</source>
        <translation>! nicht gültig</translation>
    </message>
    <message>
        <source>bits of the position</source>
        <translation>Bits der Position</translation>
    </message>
    <message>
        <source>no part of the position</source>
        <translation>kein Teil der Position</translation>
    </message>
    <message>
        <source>cams</source>
        <translation>Nocken</translation>
    </message>
</context>
<context>
    <name>codewheel::CancelQuestion</name>
    <message>
        <source>words of a cam program</source>
        <translation>Worte eines Nockenprogramms</translation>
    </message>
    <message>
        <source>a value it has not confirmed yet</source>
        <translation>einen Wert, den er noch nicht quittiert hat</translation>
    </message>
    <message>
        <source>It has already taken: %1.</source>
        <translation>Übernommen hat er schon: %1.</translation>
    </message>
    <message>
        <source>What it has taken is valid already.</source>
        <translation>Was er übernommen hat, gilt bereits.</translation>
    </message>
    <message>
        <source>Run makes what it has taken valid.</source>
        <translation>Run macht gültig, was er übernommen hat.</translation>
    </message>
    <message>
        <source>Left in parameterization, it gives no position until somebody sends run.</source>
        <translation>In der Parametrierung liefert er keine Position, bis jemand Run sendet.</translation>
    </message>
    <message>
        <source>R&amp;un with what it has</source>
        <translation>R&amp;un mit dem jetzigen Stand</translation>
    </message>
    <message>
        <source>&amp;Go on with the handshake</source>
        <translation>Handshake &amp;fortsetzen</translation>
    </message>
    <message>
        <source>Sends run: what the encoder has taken becomes valid</source>
        <translation>Sendet Run: Was der Geber übernommen hat, wird gültig</translation>
    </message>
    <message>
        <source>OUT goes back to 0, and the encoder keeps the state it is in</source>
        <translation>OUT geht zurück auf 0, und der Geber bleibt in seinem Zustand</translation>
    </message>
    <message>
        <source>The job goes on</source>
        <translation>Der Auftrag geht weiter</translation>
    </message>
    <message>
        <source>&amp;Leave it with what it has</source>
        <translation>So lassen, wie er &amp;ist</translation>
    </message>
    <message>
        <source>&amp;Leave in parameterization</source>
        <translation>In &amp;Parametrierung lassen</translation>
    </message>
    <message>
        <source>Cancel the handshake</source>
        <translation>Handshake abbrechen</translation>
    </message>
    <message>
        <source>In which state should the encoder %1 be left?</source>
        <translation>In welchem Zustand soll der Geber %1 bleiben?</translation>
    </message>
    <message>
        <source>The earlier values are not all known, so they cannot be restored.</source>
        <translation>Die vorigen Werte sind nicht alle bekannt und lassen sich deshalb nicht wiederherstellen.</translation>
    </message>
    <message>
        <source>&amp;Restore earlier values</source>
        <translation>&amp;Vorige Werte wiederherstellen</translation>
    </message>
    <message>
        <source>Writes the earlier values again</source>
        <translation>Schreibt die vorigen Werte wieder</translation>
    </message>
    <message>
        <source>Before that, run makes valid what it has taken: until the earlier values are written, the controller sees a position by these. Leave it in parameterization to avoid that.</source>
        <translation>Davor macht Run gültig, was er übernommen hat: Bis die früheren Werte geschrieben sind, sieht die Steuerung eine Position nach diesen. In der Parametrierung lassen vermeidet das.</translation>
    </message>
    <message>
        <source>The position was set. That cannot be undone, and by the earlier values the encoder would show yet another one: they are not restored.</source>
        <translation>Die Position wurde gesetzt. Das lässt sich nicht rückgängig machen, und mit den vorigen Werten würde der Geber noch eine andere zeigen: Sie werden nicht wiederhergestellt.</translation>
    </message>
    <message>
        <source>Restore writes the earlier values again and runs with them. EEPROM writes for that: %1 at most.</source>
        <translation>Wiederherstellen schreibt die vorigen Werte zurück und sendet Run. EEPROM-Schreibvorgänge dafür: höchstens %1.</translation>
    </message>
    <message>
        <source>Restore writes the earlier values again. EEPROM writes for that: %1 at most.</source>
        <translation>Wiederherstellen schreibt die vorigen Werte zurück. EEPROM-Schreibvorgänge dafür: höchstens %1.</translation>
    </message>
</context>
<context>
    <name>codewheel::Catalog</name>
    <message>
        <source>The file is nested too deeply.</source>
        <translation>Die Datei ist zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>A device with the key &quot;%1&quot; is in the catalog already.</source>
        <translation>Ein Gerät mit dem Schlüssel „%1“ ist schon im Katalog.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>This is not valid JSON: check brackets, commas and quotation marks.</source>
        <translation>Das ist kein gültiges JSON: Klammern, Kommas und Anführungszeichen prüfen.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>This is not UTF-8 text: save the file as UTF-8.</source>
        <translation>Das ist kein UTF-8-Text: Die Datei als UTF-8 speichern.</translation>
    </message>
    <message>
        <source>This key is here twice.</source>
        <translation>Dieser Schlüssel steht hier doppelt.</translation>
    </message>
    <message>
        <source>There is a NUL character here, which is not part of a text: remove it.</source>
        <translation>Hier steht ein NUL-Zeichen, das nicht in einen Text gehört: entfernen.</translation>
    </message>
</context>
<context>
    <name>codewheel::CheckList</name>
    <message>
        <source>Steps of the test</source>
        <translation>Schritte des Tests</translation>
    </message>
    <message>
        <source>Further steps</source>
        <translation>Weitere Schritte</translation>
    </message>
</context>
<context>
    <name>codewheel::CodeDisc</name>
    <message>
        <source>Dial</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Dial of %1</source>
        <comment>device number</comment>
        <translation>Scheibe von %1</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Umdr.</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <comment>revolutions per minute</comment>
        <translation>%1 U/min</translation>
    </message>
    <message>
        <source>%1 rpm cw</source>
        <comment>clockwise</comment>
        <translation>%1 U/min CW</translation>
    </message>
    <message>
        <source>%1 rpm ccw</source>
        <comment>counter-clockwise</comment>
        <translation>%1 U/min CCW</translation>
    </message>
    <message>
        <source>No position yet. Start the bus and choose an encoder in the bus structure.</source>
        <translation>Noch keine Position. Den Bus starten und im Busaufbau einen Geber wählen.</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>Umdrehung %1</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>Velocity %1</source>
        <translation>Drehzahl %1</translation>
    </message>
    <message>
        <source>Last position %1</source>
        <translation>Letzte Position %1</translation>
    </message>
    <message>
        <source>Last position</source>
        <translation>Letzte Position</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>codewheel::CommandLine</name>
    <message>
        <source>There is no option &quot;%1&quot; of %2. Its options are: %3.</source>
        <translation>%2 hat keine Option „%1“. Seine Optionen sind: %3.</translation>
    </message>
    <message>
        <source>%1 is given twice. Give it once.</source>
        <translation>%1 ist doppelt angegeben. Nur einmal angeben.</translation>
    </message>
    <message>
        <source>%1 takes no value. Give it alone.</source>
        <translation>%1 hat keinen Wert. Allein angeben.</translation>
    </message>
    <message>
        <source>%1 needs a value: %1 %2.</source>
        <translation>%1 braucht einen Wert: %1 %2.</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Give a whole number from %3 to %4.</source>
        <translation>%1 kann nicht „%2“ sein. Eine ganze Zahl von %3 bis %4 angeben.</translation>
    </message>
    <message>
        <source>The device at %1 is not an encoder this program can drive. See codewheel-cli scan.</source>
        <translation>Das Gerät an %1 ist kein Geber, den dieses Programm ansteuern kann. Siehe codewheel-cli scan.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>device code</source>
        <translation>Gerätecode</translation>
    </message>
    <message>
        <source>read-out</source>
        <translation>Auslesen</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>factory</source>
        <translation>Werk</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>EEPROM writes: not stated in the manual</source>
        <translation>EEPROM-Schreibvorgänge: im Handbuch nicht angegeben</translation>
    </message>
    <message>
        <source>EEPROM writes: about %1</source>
        <translation>EEPROM-Schreibvorgänge: etwa %1</translation>
    </message>
    <message>
        <source>EEPROM writes: about %1, nothing is guaranteed past %2</source>
        <translation>EEPROM-Schreibvorgänge: etwa %1, über %2 ohne Gewähr</translation>
    </message>
    <message>
        <source>list the encoders this program knows</source>
        <translation>die Geber auflisten, die dieses Programm kennt</translation>
    </message>
    <message>
        <source>whose word it is (see devices)</source>
        <translation>um wessen Wort es geht (siehe devices)</translation>
    </message>
    <message>
        <source>out: master to encoder; in: encoder to master</source>
        <translation>out: Master an Geber; in: Geber an Master</translation>
    </message>
    <message>
        <source>the mode the encoder is in, if it has several</source>
        <translation>die Betriebsart des Gebers, falls er mehrere hat</translation>
    </message>
    <message>
        <source>how positions are coded: 1 to 6, or its name</source>
        <translation>wie Positionen codiert sind: 1 bis 6 oder der Name</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. Allowed are: %3.</source>
        <translation>%1 kann nicht „%2“ sein. Erlaubt sind: %3.</translation>
    </message>
    <message>
        <source>%1 is missing. Give one of: %2.</source>
        <translation>%1 fehlt. Eines davon angeben: %2.</translation>
    </message>
    <message>
        <source>The %1 has one coding only. Leave --coding out.</source>
        <translation>Der Geber %1 hat nur eine Codierung. --coding weglassen.</translation>
    </message>
    <message>
        <source>One of these. To narrow it down: %1.</source>
        <translation>Eines davon. Genauer wird es mit: %1.</translation>
    </message>
    <message>
        <source>explain what a word means</source>
        <translation>erklären, was ein Wort bedeutet</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. The commands are: %2. See codewheel-cli --help.</source>
        <translation>Es gibt keinen Befehl „%1“. Die Befehle sind: %2. Siehe codewheel-cli --help.</translation>
    </message>
    <message>
        <source>Name a command: %1. See codewheel-cli --help.</source>
        <translation>Einen Befehl angeben: %1. Siehe codewheel-cli --help.</translation>
    </message>
    <message>
        <source>Something is missing. Usage: codewheel-cli %1</source>
        <translation>Es fehlt etwas. Der Aufruf lautet: codewheel-cli %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too much. Usage: codewheel-cli %2</source>
        <translation>„%1“ ist zu viel. Der Aufruf lautet: codewheel-cli %2</translation>
    </message>
    <message>
        <source>how long to look (10)</source>
        <translation>wie lange beobachtet wird (10)</translation>
    </message>
    <message>
        <source>how often to look (100)</source>
        <translation>wie oft nachgesehen wird (100)</translation>
    </message>
    <message>
        <source>print the words that went over the bus</source>
        <translation>die Worte ausgeben, die über den Bus gingen</translation>
    </message>
    <message>
        <source>Position before: %1</source>
        <translation>Position vorher:        %1</translation>
    </message>
    <message>
        <source>Position after:  %1</source>
        <translation>Position nachher:       %1</translation>
    </message>
    <message>
        <source>EEPROM writes:   %1</source>
        <translation>EEPROM-Schreibvorgänge: %1</translation>
    </message>
    <message>
        <source>set the position of an encoder</source>
        <translation>die Position eines Gebers setzen</translation>
    </message>
    <message>
        <source>Nothing was written to it from here either, so nothing is known of it.</source>
        <translation>Auch von hier wurde nichts in ihn geschrieben, deshalb ist nichts von ihm bekannt.</translation>
    </message>
    <message>
        <source>Last written from here:</source>
        <translation>Zuletzt von hier geschrieben:</translation>
    </message>
    <message>
        <source>read the parameters that an encoder has</source>
        <translation>die Parameter eines Gebers auslesen</translation>
    </message>
    <message>
        <source>make not known</source>
        <translation>Hersteller unbekannt</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>ID code</source>
        <translation>ID-Code</translation>
    </message>
    <message>
        <source>IN words</source>
        <translation>IN-Worte</translation>
    </message>
    <message>
        <source>OUT words</source>
        <translation>OUT-Worte</translation>
    </message>
    <message>
        <source>send words as they are, and print what comes back</source>
        <translation>Worte unverändert senden und ausgeben, was zurückkommt</translation>
    </message>
    <message>
        <source>write without asking</source>
        <translation>ohne Rückfrage schreiben</translation>
    </message>
    <message>
        <source>show what would be written, and send nothing</source>
        <translation>zeigen, was geschrieben würde, und nichts senden</translation>
    </message>
    <message>
        <source>write also what the encoder already has</source>
        <translation>auch schreiben, was schon im Geber steht</translation>
    </message>
    <message>
        <source>Nothing was sent: there is nobody to ask. Add --yes to write, or --dry-run to look only.</source>
        <translation>Nichts gesendet: Es ist niemand da, der gefragt werden kann. Zum Schreiben --yes angeben, nur zum Ansehen --dry-run.</translation>
    </message>
    <message>
        <source>Write this to %1?</source>
        <translation>Das an %1 schreiben?</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Nichts gesendet.</translation>
    </message>
    <message>
        <source>written, and read back</source>
        <translation>geschrieben und zurückgelesen</translation>
    </message>
    <message>
        <source>written, confirmed by the handshake</source>
        <translation>geschrieben, im Handshake quittiert</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>war schon vorhanden</translation>
    </message>
    <message>
        <source>did not become active</source>
        <translation>nicht wirksam geworden</translation>
    </message>
    <message>
        <source>The encoder was left in parameterization: it shows no position.</source>
        <translation>Der Geber blieb in der Parametrierung: Er zeigt keine Position.</translation>
    </message>
    <message>
        <source>The encoder was left in error: it shows no position.</source>
        <translation>Der Geber blieb im Fehlerzustand: Er zeigt keine Position.</translation>
    </message>
    <message>
        <source>The encoder is in operation.</source>
        <translation>Der Geber ist in Betrieb.</translation>
    </message>
    <message>
        <source>write parameters, after showing what and asking</source>
        <translation>Parameter schreiben, nach Anzeige und Rückfrage</translation>
    </message>
    <message>
        <source>answer as one JSON object, for programs</source>
        <translation>Antwort als ein JSON-Objekt, für Programme</translation>
    </message>
    <message>
        <source>explain this and stop; also -h</source>
        <translation>diese Hilfe ausgeben und beenden; auch -h</translation>
    </message>
    <message>
        <source>print the version and stop</source>
        <translation>die Version ausgeben und beenden</translation>
    </message>
    <message>
        <source>There is no device named &quot;%1&quot;. The names are: %2.</source>
        <translation>Es gibt kein Gerät namens „%1“. Die Namen sind: %2.</translation>
    </message>
    <message>
        <source>Usage: codewheel-cli COMMAND ...</source>
        <translation>Aufruf: codewheel-cli COMMAND ...</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>Befehle:</translation>
    </message>
    <message>
        <source>Options of every command:</source>
        <translation>Optionen aller Befehle:</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Beispiele:</translation>
    </message>
    <message>
        <source>Usage: codewheel-cli %1</source>
        <translation>Aufruf: codewheel-cli %1</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>Optionen:</translation>
    </message>
    <message>
        <source>It has: %1.</source>
        <translation>Er hat: %1.</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. The %2 has: %3.</source>
        <translation>Es gibt keinen Parameter „%1“. Der Geber %2 hat: %3.</translation>
    </message>
    <message>
        <source>Hexadecimal numbers are written 0xFF or FFh.</source>
        <translation>Hexadezimale Zahlen haben die Form 0xFF oder FFh.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a word. Give up to 8 hexadecimal digits, such as 020000FF.</source>
        <translation>„%1“ ist kein Wort. Bis zu 8 Hexziffern angeben, etwa 020000FF.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not PARAMETER=VALUE. Write for example steps=255.</source>
        <translation>„%1“ hat nicht die Form PARAMETER=VALUE. Zum Beispiel: steps=255.</translation>
    </message>
    <message>
        <source>IN %1, and how it is coded is not known</source>
        <translation>IN %1, Codierung unbekannt</translation>
    </message>
    <message>
        <source>y/N</source>
        <comment>answers to a question</comment>
        <translation>j/N</translation>
    </message>
    <message>
        <source>y</source>
        <comment>answer to a question</comment>
        <translation>j</translation>
    </message>
    <message>
        <source>yes</source>
        <comment>answer to a question</comment>
        <translation>ja</translation>
    </message>
    <message>
        <source>cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>OUT means</source>
        <translation>OUT bedeutet</translation>
    </message>
    <message>
        <source>IN means</source>
        <translation>IN bedeutet</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>gewünscht</translation>
    </message>
    <message>
        <source>left out: already there</source>
        <translation>entfällt: schon vorhanden</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Run</translation>
    </message>
    <message>
        <source>To be written to %1, %2:</source>
        <translation>An %1, %2, ist zu schreiben:</translation>
    </message>
    <message>
        <source>The encoder has all of it: there is nothing to write.</source>
        <translation>Das alles steht schon im Geber: Es gibt nichts zu schreiben.</translation>
    </message>
    <message>
        <source>send the FRABA preset, which works as often as wanted</source>
        <translation>den FRABA-Preset senden, der beliebig oft wirkt</translation>
    </message>
    <message>
        <source>Makes the encoder show its preset value at the place where its shaft stands. With a VALUE, that is
written as the preset first. Sends at once, without asking.

A FRABA encoder activates a preset once; it is programmed again where that is needed. The FRABA preset
(60000000, for one bus cycle) needs no programming again.</source>
        <translation>Setzt die Position: Dort, wo die Welle steht, zeigt der Geber seinen Presetwert. VALUE wird zuvor
als Preset geschrieben. Sendet sofort, ohne zu fragen.

Ein FRABA-Geber aktiviert einen Preset nur einmal; wo nötig, wird er neu programmiert. Der FRABA-Preset
(60000000, einen Buszyklus lang) braucht das nicht.</translation>
    </message>
    <message>
        <source>reset without asking</source>
        <translation>zurücksetzen, ohne zu fragen</translation>
    </message>
    <message>
        <source>%1, %2, will be reset to factory settings (0E000000, then run).</source>
        <translation>%1, %2, wird auf Werkseinstellungen zurückgesetzt (0E000000, dann Run).</translation>
    </message>
    <message>
        <source>All cam programs are lost, too, and the encoder is in position mode afterwards.</source>
        <translation>Auch alle Nockenprogramme gehen verloren; danach ist der Geber im Positionsbetrieb.</translation>
    </message>
    <message>
        <source>, and 1 more where it is in a cam program that was changed</source>
        <translation>, und einer mehr, wenn er in einem geänderten Nockenprogramm ist</translation>
    </message>
    <message>
        <source>Read back:</source>
        <translation>Zurückgelesen:</translation>
    </message>
    <message>
        <source>Factory settings, confirmed by the handshake:</source>
        <translation>Werkseinstellungen, im Handshake quittiert:</translation>
    </message>
    <message>
        <source>Reset %1?</source>
        <translation>%1 zurücksetzen?</translation>
    </message>
    <message>
        <source>Nothing was sent: there is nobody to ask. Add --yes to reset.</source>
        <translation>Nichts gesendet: Es ist niemand da, der gefragt werden kann. Zum Zurücksetzen --yes angeben.</translation>
    </message>
    <message>
        <source>reset an encoder to factory settings, after asking</source>
        <translation>einen Geber nach Rückfrage auf Werkseinstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>Tells what is lost and what it costs; asks; resets the encoder; and tells what it has then, read back
where that is possible. Where nobody can be asked, --yes is needed: without it nothing is sent, exit
code 2.</source>
        <translation>Sagt, was verloren geht und was es kostet; fragt; setzt den Geber zurück; und sagt, was er danach hat,
zurückgelesen, wo das geht. Wo niemand gefragt werden kann, ist --yes nötig: Sonst wird nichts gesendet,
Rückgabewert 2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither on nor off.</source>
        <translation>„%1“ ist weder on noch off.</translation>
    </message>
    <message>
        <source>Velocity mode: %1 rpm</source>
        <translation>Drehzahlbetrieb: %1 U/min</translation>
    </message>
    <message>
        <source>Position mode: %1</source>
        <translation>Positionsbetrieb: %1</translation>
    </message>
    <message>
        <source>let an encoder show its speed, or its position again</source>
        <translation>einen Geber die Drehzahl statt der Position zeigen lassen oder umgekehrt</translation>
    </message>
    <message>
        <source>not shown in velocity mode</source>
        <translation>wird im Drehzahlbetrieb nicht gezeigt</translation>
    </message>
    <message>
        <source>Cam program %1: nothing is set</source>
        <translation>Nockenprogramm %1: nichts gesetzt</translation>
    </message>
    <message>
        <source>Cam program %1, shift %2</source>
        <translation>Nockenprogramm %1, Verschiebung %2</translation>
    </message>
    <message>
        <source>cam</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>only this cam program, 1 to 8</source>
        <translation>nur dieses Nockenprogramm, 1 bis 8</translation>
    </message>
    <message>
        <source>leave the encoder in cam mode, in the last of the programs</source>
        <translation>den Geber im Nockenbetrieb lassen, im letzten der Programme</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number of a cam program. Choose one from 1 to 8.</source>
        <translation>„%1“ ist keine Nummer eines Nockenprogramms. Eine von 1 bis 8 wählen.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>The encoder has all of it.</source>
        <translation>Das alles steht schon im Geber.</translation>
    </message>
    <message>
        <source>The encoder and the file differ in values: %1.</source>
        <translation>Zwischen Geber und Datei abweichende Werte: %1.</translation>
    </message>
    <message>
        <source>Words to be sent, beside read-outs: %1</source>
        <translation>Zu sendende Worte, ohne das Auslesen: %1</translation>
    </message>
    <message>
        <source>EEPROM writes: %1, one for each program that is changed and left.</source>
        <translation>EEPROM-Schreibvorgänge: %1, einer je Programm, das geändert und verlassen wird.</translation>
    </message>
    <message>
        <source>Nothing was written: there is nobody to ask. Add --yes to write, or use compare to look only.</source>
        <translation>Nichts geschrieben: Es ist niemand da, der gefragt werden kann. Zum Schreiben --yes angeben, nur zum Ansehen compare.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of read, write and compare.</source>
        <translation>„%1“ ist weder read noch write noch compare.</translation>
    </message>
    <message>
        <source>Name the file of the cam programs.</source>
        <translation>Die Datei mit den Nockenprogrammen angeben.</translation>
    </message>
    <message>
        <source>read, write and compare cam programs</source>
        <translation>Nockenprogramme lesen, schreiben und vergleichen</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>The encoder was left in service mode: it shows no position.</source>
        <translation>Der Geber blieb im Dienstbetrieb: Er zeigt keine Position.</translation>
    </message>
    <message>
        <source>The encoder was left in error: it shows the last position it knew.</source>
        <translation>Der Geber blieb im Fehlerzustand: Er zeigt die letzte bekannte Position.</translation>
    </message>
    <message>
        <source>what the key on a label says, and whose it is</source>
        <translation>was der Schlüssel auf einem Typenschild bedeutet und zu welchem Gerät er gehört</translation>
    </message>
    <message>
        <source>Give one of these: a NAME, --label KEY or --check FILE.</source>
        <translation>Eines davon angeben: einen NAME, --label KEY oder --check FILE.</translation>
    </message>
    <message>
        <source>Lists the encoders this program knows. With a NAME: its parameters with their numbers,
read-out codes, factory values and ranges, its errors, how often its EEPROM can be written, and
what its manual&apos;s tables say: pins, LEDs, supply, limits, ordering key. Descriptions of your own
are read from ~/.local/share/codewheel/devices/*.json; --check tells whether one is sound.</source>
        <translation>Listet die Geber auf, die dieses Programm kennt. Mit NAME: seine Parameter mit Nummern, Auslesecodes,
Werkseinstellungen und Bereichen, seine Fehler, wie oft sein EEPROM beschreibbar ist, und was die
Tabellen seines Handbuchs sagen: Anschlüsse, LEDs, Versorgung, Grenzwerte, Typenschlüssel. Eigene
Beschreibungen kommen aus ~/.local/share/codewheel/devices/*.json; --check prüft eine davon.</translation>
    </message>
    <message>
        <source>One of these: the key does not say which. The device code on the bus does.</source>
        <translation>Einer von diesen: Aus dem Schlüssel geht nicht hervor, welcher. Der Gerätecode am Bus sagt es.</translation>
    </message>
    <message>
        <source>Turns and steps per turn: not stated.</source>
        <translation>Umdrehungen und Schritte je Umdrehung: nicht genannt.</translation>
    </message>
    <message>
        <source>Turns: %1, steps per turn: %2</source>
        <translation>Umdrehungen: %1, Schritte je Umdrehung: %2</translation>
    </message>
    <message>
        <source> (from the description: the key does not state them)</source>
        <translation> (aus der Beschreibung: Der Schlüssel nennt sie nicht)</translation>
    </message>
    <message>
        <source>%1 (manual: %2)</source>
        <comment>Electrical data (manual: 6.1)</comment>
        <translation>%1 (Handbuch: %2)</translation>
    </message>
    <message>
        <source>%1 blinking</source>
        <translation>%1 blinkt</translation>
    </message>
    <message>
        <source>LEDs</source>
        <translation>LEDs</translation>
    </message>
    <message>
        <source>Ordering key, e.g. %1</source>
        <translation>Typenschlüssel, z. B. %1</translation>
    </message>
    <message>
        <source>any, may be missing</source>
        <translation>beliebig, kann fehlen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source>IN %1, and the mode of the encoder is not known</source>
        <translation>IN %1, und die Betriebsart des Gebers ist unbekannt</translation>
    </message>
    <message>
        <source>%1 is there already. Nothing was read. Name another file, or add --yes to replace it.</source>
        <translation>%1 gibt es schon. Es wurde nichts gelesen. Eine andere Datei angeben oder mit --yes ersetzen.</translation>
    </message>
    <message>
        <source>cam programs as well</source>
        <translation>auch die Nockenprogramme</translation>
    </message>
    <message>
        <source>Nothing is known of %1: it cannot be read, and nothing was written to it from here.</source>
        <translation>Von %1 ist nichts bekannt: Er lässt sich nicht auslesen, und von hier wurde nichts in ihn geschrieben.</translation>
    </message>
    <message>
        <source>give other encoders the values of one</source>
        <translation>die Werte eines Gebers in andere Geber übertragen</translation>
    </message>
    <message>
        <source>read the cam programs as well</source>
        <translation>auch die Nockenprogramme lesen</translation>
    </message>
    <message>
        <source>Nothing is known of it.</source>
        <translation>Von ihm ist nichts bekannt.</translation>
    </message>
    <message>
        <source>write what was stored of the encoders, not what is wanted</source>
        <translation>schreiben, was von den Gebern abgelegt ist, nicht was gewünscht ist</translation>
    </message>
    <message>
        <source>write the values of a project to its encoders</source>
        <translation>die Werte eines Projekts in seine Geber schreiben</translation>
    </message>
    <message>
        <source>Not all of it was written, first of all to %1.</source>
        <translation>Nicht alles wurde geschrieben; zuerst nicht bei %1.</translation>
    </message>
    <message>
        <source>Write this to encoders: %1, with at most so many EEPROM writes: %2?</source>
        <translation>Dies schreiben (Geber: %1, EEPROM-Schreibvorgänge höchstens: %2)?</translation>
    </message>
    <message>
        <source>Nothing was written: there is nobody to ask. Add --yes to write, or --dry-run to look only.</source>
        <translation>Nichts geschrieben: Es ist niemand da, der gefragt werden kann. Zum Schreiben --yes angeben, nur zum Ansehen --dry-run.</translation>
    </message>
    <message>
        <source>show what would be written, and write nothing</source>
        <translation>zeigen, was geschrieben würde, und nichts schreiben</translation>
    </message>
    <message>
        <source>cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>Written: %1. Already there: %2. EEPROM writes: %3.</source>
        <translation>Geschrieben: %1. Schon vorhanden: %2. EEPROM-Schreibvorgänge: %3.</translation>
    </message>
    <message>
        <source>The bus differs from %1. Lines that differ: %2.</source>
        <translation>Der Bus weicht von %1 ab. Abweichende Zeilen: %2.</translation>
    </message>
    <message>
        <source>compare a project with the bus</source>
        <translation>ein Projekt mit dem Bus vergleichen</translation>
    </message>
    <message>
        <source>of this file, in place of the user&apos;s own</source>
        <translation>aus dieser Datei statt aus der des Benutzers</translation>
    </message>
    <message>
        <source>serial number, read</source>
        <translation>Seriennummer, gelesen</translation>
    </message>
    <message>
        <source>serial number of the label</source>
        <translation>Seriennummer vom Typenschild</translation>
    </message>
    <message>
        <source>since</source>
        <translation>seit</translation>
    </message>
    <message>
        <source>last at</source>
        <translation>zuletzt an</translation>
    </message>
    <message>
        <source>writes</source>
        <translation>Schreibvorgänge</translation>
    </message>
    <message>
        <source>perhaps</source>
        <translation>vielleicht</translation>
    </message>
    <message>
        <source>counted by</source>
        <translation>gezählt nach</translation>
    </message>
    <message>
        <source>No EEPROM writes are counted in %1.</source>
        <translation>In %1 sind keine EEPROM-Schreibvorgänge gezählt.</translation>
    </message>
    <message>
        <source>list how often this program wrote to EEPROMs</source>
        <translation>auflisten, wie oft dieses Programm in EEPROMs geschrieben hat</translation>
    </message>
    <message>
        <source>let so many milliseconds pass on the bus first</source>
        <translation>zuerst so viele Millisekunden am Bus vergehen lassen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an action of the master. There are: %2.</source>
        <translation>„%1“ ist keine Aktion des Masters. Es gibt: %2.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>what the master says, and its services</source>
        <translation>Zustand und Dienste des Masters</translation>
    </message>
    <message>
        <source>information, attention or fault: this or worse</source>
        <translation>information, attention oder fault: diese Stufe oder höher</translation>
    </message>
    <message>
        <source>from this time on: 2026-03-01 or 2026-03-01T14:02</source>
        <translation>ab dieser Zeit: 2026-03-01 oder 2026-03-01T14:02</translation>
    </message>
    <message>
        <source>before this time</source>
        <translation>vor dieser Zeit</translation>
    </message>
    <message>
        <source>the newest N (100); 0: all</source>
        <translation>die neuesten N (100); 0: alle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Write it as 2026-03-01 or 2026-03-01T14:02.</source>
        <translation>„%1“ ist keine Zeitangabe. Als 2026-03-01 oder 2026-03-01T14:02 schreiben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a severity. There are: information, attention, fault.</source>
        <translation>„%1“ ist keine Stufe. Es gibt: information, attention, fault.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no format. Let the name end in .csv or .html.</source>
        <translation>„%1“ nennt kein Format. Der Name muss auf .csv oder .html enden.</translation>
    </message>
    <message>
        <source>Messages written to %1: %2.</source>
        <translation>In %1 geschriebene Meldungen: %2.</translation>
    </message>
    <message>
        <source>Lists the messages that the window keeps on disk, oldest first: those that fit all that is given.
Needs no bus.</source>
        <translation>Listet die Meldungen auf, die das Fenster auf der Festplatte aufbewahrt, die älteste zuerst: alle, auf
die sämtliche Angaben zutreffen. Braucht keinen Bus.</translation>
    </message>
    <message>
        <source>do not ask where the budget of the EEPROM is used</source>
        <translation>nicht fragen, wo die Schreibvorgänge des EEPROMs aufgebraucht sind</translation>
    </message>
    <message>
        <source>save what was found as a project</source>
        <translation>das Gefundene als Projekt speichern</translation>
    </message>
    <message>
        <source>replace FILE if it is there</source>
        <translation>FILE ersetzen, wenn es schon da ist</translation>
    </message>
    <message>
        <source>%1 is there already. Nothing was saved. Name another file, or add --yes to replace it; the old one is kept as %2.</source>
        <translation>%1 gibt es schon. Nichts wurde gespeichert. Eine andere Datei nennen oder mit --yes ersetzen; die alte bleibt als %2 erhalten.</translation>
    </message>
    <message>
        <source>name encoders as this project does; PLACE may be the name of a station</source>
        <translation>Geber so benennen wie dieses Projekt; PLACE darf auch der Name einer Station sein</translation>
    </message>
    <message>
        <source>faults that happen to the training bus, with their times and places</source>
        <translation>Fehler, die den Übungsbus treffen, mit Zeit und Ort</translation>
    </message>
    <message>
        <source>Type %1 to write nevertheless:</source>
        <translation>%1 eintippen, um trotzdem zu schreiben:</translation>
    </message>
    <message>
        <source>Write to the EEPROM nevertheless?</source>
        <translation>Trotzdem in das EEPROM schreiben?</translation>
    </message>
    <message>
        <source>write even where the manual guarantees nothing any more: the place (or places, as 1.0,2.0) once more</source>
        <translation>auch schreiben, wo das Handbuch nichts mehr zusichert: den Platz (oder die Plätze, etwa 1.0,2.0) noch einmal nennen</translation>
    </message>
    <message>
        <source>count EEPROM writes in this file; those of the training bus are else forgotten</source>
        <translation>EEPROM-Schreibvorgänge in dieser Datei zählen; die des Übungsbusses werden sonst vergessen</translation>
    </message>
    <message>
        <source>Segment %1:      switched off</source>
        <translation>Segment %1:      abgeschaltet</translation>
    </message>
    <message>
        <source>Segment %1:      CRC errors: %2</source>
        <translation>Segment %1:      CRC-Fehler: %2</translation>
    </message>
    <message>
        <source>Master:         not reached by this link</source>
        <translation>Master:         über diese Verbindung nicht erreichbar</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Master:         %1</source>
        <translation>Master:         %1</translation>
    </message>
    <message>
        <source>Status:         %1 (%2)</source>
        <translation>Status:         %1 (%2)</translation>
    </message>
    <message>
        <source>Fault:          %1</source>
        <translation>Fehler:         %1</translation>
    </message>
    <message>
        <source>Configuration:  %1</source>
        <translation>Konfiguration:  %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a device number nor a station of the project.</source>
        <translation>„%1“ ist weder eine Teilnehmernummer noch eine Station des Projekts.</translation>
    </message>
    <message>
        <source>where to save the report: a name in .html or .pdf</source>
        <translation>wo der Bericht gespeichert wird: ein Name auf .html oder .pdf</translation>
    </message>
    <message>
        <source>Name the file of the report: -o FILE, with a name that ends in .html or .pdf.</source>
        <translation>Die Datei des Berichts nennen: -o FILE, mit einem Namen auf .html oder .pdf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; ends neither in .html nor in .pdf. A report is a web page or a PDF.</source>
        <translation>„%1“ endet weder auf .html noch auf .pdf. Ein Bericht ist eine Webseite oder ein PDF.</translation>
    </message>
    <message>
        <source>%1 is there already. Nothing was saved. Name another file, or add --yes to replace it.</source>
        <translation>%1 gibt es schon. Nichts wurde gespeichert. Eine andere Datei nennen oder mit --yes ersetzen.</translation>
    </message>
    <message>
        <source>%1 could not be read: %2</source>
        <translation>%1 ließ sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>Deviations of encoders from what is wanted: %1; not compared: %2.</source>
        <translation>Abweichungen der Geber vom Gewünschten: %1; nicht verglichen: %2.</translation>
    </message>
    <message>
        <source>make the commissioning report of a project</source>
        <translation>den Inbetriebnahmebericht eines Projekts erstellen</translation>
    </message>
    <message>
        <source>Saves the commissioning report of a project, as a web page or as a PDF on A4: structure, parameters
and cams of each encoder with what is known of them, deviations, EEPROM writes, and a place to sign.

What is known is what the project has stored. With --read, the encoders are asked for their parameters,
and for the cam programs the project wants; they show no position meanwhile. The bus is compared with
the project then. A FILE that is there already is replaced with --yes only.</source>
        <translation>Speichert den Inbetriebnahmebericht eines Projekts als Webseite oder als PDF auf A4: Aufbau, Parameter
und Nocken jedes Gebers mit dem, was bekannt ist, Abweichungen, EEPROM-Schreibvorgänge und Platz zum
Unterschreiben.

Bekannt ist, was im Projekt abgelegt ist. Mit --read werden von den Gebern die Parameter gelesen und
die Nockenprogramme, die das Projekt wünscht; solange zeigen sie keine Position. Dann wird auch der
Bus mit dem Projekt verglichen. Eine vorhandene FILE wird nur mit --yes ersetzt.</translation>
    </message>
    <message>
        <source>of 1000 bytes, so many are lost</source>
        <translation>so viele von 1000 Bytes gehen verloren</translation>
    </message>
    <message>
        <source>of 1000 bytes, so many are wrong in one bit</source>
        <translation>so viele von 1000 Bytes sind in einem Bit falsch</translation>
    </message>
    <message>
        <source>of 1000 bytes, so many come twice</source>
        <translation>so viele von 1000 Bytes kommen doppelt</translation>
    </message>
    <message>
        <source>of 1000 bytes, so many come later, with all that follow them</source>
        <translation>so viele von 1000 Bytes kommen später, mit allen, die ihnen folgen</translation>
    </message>
    <message>
        <source>how much later (20)</source>
        <translation>wie viel später (20)</translation>
    </message>
    <message>
        <source>from a request to its answer (0)</source>
        <translation>von einer Anfrage bis zu ihrer Antwort (0)</translation>
    </message>
    <message>
        <source>send back what comes in, as a half-duplex adapter</source>
        <translation>zurücksenden, was ankommt, wie ein Halbduplex-Adapter</translation>
    </message>
    <message>
        <source>an encoder that does not answer; several as 03,12; all for all of them</source>
        <translation>ein Geber, der nicht antwortet; mehrere als 03,12; all für alle</translation>
    </message>
    <message>
        <source>another run of the same faults (1)</source>
        <translation>ein anderer Verlauf derselben Fehler (1)</translation>
    </message>
    <message>
        <source>This computer gives no pseudo terminal. Close programs that use some.</source>
        <translation>Dieser Rechner stellt kein Pseudoterminal bereit. Programme schließen, die welche benutzen.</translation>
    </message>
    <message>
        <source>do it without asking</source>
        <translation>ohne Rückfrage ausführen</translation>
    </message>
    <message>
        <source>Put segment %1 back into the data cycles?</source>
        <translation>Segment %1 wieder in die Datenzyklen nehmen?</translation>
    </message>
    <message>
        <source>%1 (OUT %2)</source>
        <translation>%1 (OUT %2)</translation>
    </message>
    <message>
        <source>Switch segment %1 off? Out of the data cycles go, with outputs at 0: %2.</source>
        <translation>Segment %1 abschalten? Aus den Datenzyklen gehen, mit Ausgängen auf 0: %2.</translation>
    </message>
    <message>
        <source>Read in the ring? Data cycles stop meanwhile.</source>
        <translation>Den Ring einlesen? Die Datenzyklen stehen solange still.</translation>
    </message>
    <message>
        <source>Confirm diagnostics?</source>
        <translation>Diagnose quittieren?</translation>
    </message>
    <message>
        <source>Nothing was sent: there is nobody to ask. Add --yes to do it.</source>
        <translation>Nichts gesendet: Es ist niemand da, der gefragt werden kann. Zum Ausführen --yes angeben.</translation>
    </message>
    <message>
        <source>Lets time pass, does what is asked for, and prints what the bus told meanwhile and how the master stands
then. What changes what the ring does (read-in, confirm, segment) is asked for first; where nobody can
be asked, --yes is needed. As each call has a new training bus, this makes most sense with a fault plan.</source>
        <translation>Lässt Zeit vergehen, tut, was verlangt ist, und gibt aus, was der Bus inzwischen gemeldet hat und in welchem
Zustand der Master dann ist. Vor Eingriffen in den Ring (read-in, confirm, segment) wird gefragt; wo
niemand gefragt werden kann, ist --yes nötig. Da jeder Aufruf einen neuen Übungsbus hat, ist das vor
allem mit einem Fehlerplan sinnvoll.</translation>
    </message>
    <message>
        <source>write without asking, also where the budget of the EEPROM is used; replace FILE when reading</source>
        <translation>ohne Rückfrage schreiben, auch wenn die Schreibvorgänge des EEPROMs aufgebraucht sind; beim Lesen FILE ersetzen</translation>
    </message>
    <message>
        <source>the new encoder: the key on its label</source>
        <translation>der neue Geber: der Schlüssel auf seinem Typenschild</translation>
    </message>
    <message>
        <source>the serial number on the label of the new encoder</source>
        <translation>die Seriennummer auf dem Typenschild des neuen Gebers</translation>
    </message>
    <message>
        <source>set the position to this, in steps; &quot;last&quot; is the one the project knows</source>
        <translation>die Position auf diesen Wert setzen, in Schritten; „last“ ist die, die das Projekt kennt</translation>
    </message>
    <message>
        <source>Give --device or --label, not both: each names the new encoder.</source>
        <translation>Entweder --device oder --label angeben: Jedes benennt den neuen Geber.</translation>
    </message>
    <message>
        <source>The project does not name the encoder at %1. Name the new one with --device or --label.</source>
        <translation>Das Projekt benennt den Geber an %1 nicht. Den neuen mit --device oder --label benennen.</translation>
    </message>
    <message>
        <source>The project knows no last position of %1. Give it as a number.</source>
        <translation>Das Projekt kennt keine letzte Position von %1. Die Position als Zahl angeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a position. Give a whole number, 0 or more.</source>
        <translation>„%1“ ist keine Position. Eine ganze Zahl ab 0 angeben.</translation>
    </message>
    <message>
        <source>The position that the project keeps: %1, seen at %2.</source>
        <translation>Die Position, die das Projekt aufbewahrt: %1, gesehen am %2.</translation>
    </message>
    <message>
        <source>Name the project with --project FILE: the values are taken from it, and the new encoder is put into it.</source>
        <translation>Das Projekt mit --project FILE nennen: Ihm werden die Werte entnommen, und der neue Geber wird darin eingetragen.</translation>
    </message>
    <message>
        <source>Tells how the new encoder differs from the one the project has at PLACE, shows what will be written,
asks, puts the new one into the project (make, label and serial number; the file that was there is
kept as FILE~), and writes what the project wants, and where nothing is wanted what was stored of the
one before. With --position the position is set at the end of it: the shaft must stand where it stood
then. The old zero offset is not written in that case, since setting the position makes a new one.
An encoder with several modes is brought to position mode first. Exit code 1 if the encoder has not
got all of it.</source>
        <translation>Sagt, worin sich der neue Geber von dem unterscheidet, den das Projekt an PLACE hat, zeigt, was
geschrieben wird, fragt, trägt den neuen im Projekt ein (Hersteller, Typenschild und Seriennummer; die
vorige Datei bleibt als FILE~ erhalten) und schreibt, was das Projekt wünscht, und wo nichts gewünscht
ist, was vom vorigen abgelegt ist. Mit --position wird zum Schluss die Position gesetzt: Die Welle
muss dabei stehen, wo sie damals stand. Die alte Nullpunkt-Verschiebung wird dann nicht geschrieben,
denn das Setzen der Position ergibt eine neue. Ein Geber mit mehreren Betriebsarten wird zuerst in den
Positionsbetrieb gebracht. Rückgabewert 1, wenn der Geber nicht alles bekommen hat.</translation>
    </message>
    <message>
        <source>replace FILE if it is there; do not ask where the budget of an EEPROM is used</source>
        <translation>FILE ersetzen, falls sie da ist; nicht fragen, wenn die Schreibvorgänge eines EEPROMs aufgebraucht sind</translation>
    </message>
    <message>
        <source>of the write at this time: 2026-03-01T14:02, or 14:02 of today; else of the newest</source>
        <translation>des Schreibens zu dieser Zeit: 2026-03-01T14:02, oder 14:02 von heute; sonst des jüngsten</translation>
    </message>
    <message>
        <source>list what there is, and write nothing</source>
        <translation>sagen, was es gibt, und nichts schreiben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Write it as 14:02 or 2026-03-01T14:02.</source>
        <translation>„%1“ ist keine Zeitangabe. Als 14:02 oder 2026-03-01T14:02 schreiben.</translation>
    </message>
    <message>
        <source>write the values again that an encoder had before a write</source>
        <translation>vorige Werte eines Gebers wiederherstellen</translation>
    </message>
    <message>
        <source>The ledger of EEPROM writes keeps with each write what was known of the encoder before, and what was
read then. --list tells what there is, the newest first. Without --at the newest is restored: what
differs is shown, asked for, written as by &quot;transfer&quot;, and accounted for. An encoder that can tell its
serial number is asked for that where nothing is kept for its place.</source>
        <translation>Das Verzeichnis der EEPROM-Schreibvorgänge bewahrt zu jedem Schreiben auf, was vorher vom Geber bekannt war
und was dabei gelesen wurde. --list sagt, was es gibt, das Jüngste zuerst. Ohne --at wird das Jüngste
wiederhergestellt: Was abweicht, wird gezeigt, nach Rückfrage wie bei „transfer“ geschrieben und belegt. Ein
Geber, der seine Seriennummer melden kann, wird danach gefragt, wenn für seinen Platz nichts da ist.</translation>
    </message>
    <message>
        <source>In velocity mode an encoder shows whole revolutions per minute instead of its position, and goes on so
after power-off, until it is switched off. Sends at once, without asking; writes nothing to the EEPROM,
but &quot;off&quot; ends cam mode, too: a cam program that was changed is stored when it is left.</source>
        <translation>Im Drehzahlbetrieb zeigt ein Geber ganze Umdrehungen pro Minute statt seiner Position, auch nach
dem Ausschalten, bis der Betrieb beendet wird. Sendet sofort, ohne zu fragen; schreibt nichts in das
EEPROM, doch „off“ beendet auch den Nockenbetrieb: Ein geändertes Nockenprogramm wird gespeichert, wenn
es verlassen wird.</translation>
    </message>
    <message>
        <source>Position: set to %1.</source>
        <translation>Position: auf %1 gesetzt.</translation>
    </message>
    <message>
        <source>Position: not set to %1.</source>
        <translation>Position: nicht auf %1 gesetzt.</translation>
    </message>
    <message>
        <source>Encoders on a serial line have no cams.</source>
        <translation>Geber an einer seriellen Leitung haben keine Nocken.</translation>
    </message>
    <message>
        <source>written by</source>
        <translation>geschrieben mit</translation>
    </message>
    <message>
        <source>read by</source>
        <translation>gelesen mit</translation>
    </message>
    <message>
        <source>the word that stands the other way; of an answer its request</source>
        <translation>das Wort der Gegenrichtung; zu einer Antwort ihre Anfrage</translation>
    </message>
    <message>
        <source>A fault plan is for the ring of the training bus. Leave --fault-plan out.</source>
        <translation>Ein Fehlerplan gilt für den Ring des Übungsbusses. --fault-plan weglassen.</translation>
    </message>
    <message>
        <source>A serial line has no master.</source>
        <translation>Eine serielle Leitung hat keinen Master.</translation>
    </message>
    <message>
        <source>watch the words of an encoder, or its position</source>
        <translation>die Worte oder die Position eines Gebers beobachten</translation>
    </message>
    <message>
        <source>Encoders on a serial line have no command that resets them to factory settings. Write the values with codewheel-cli write.</source>
        <translation>Geber an einer seriellen Leitung haben keinen Befehl, der sie auf Werkseinstellungen zurücksetzt. Die Werte mit codewheel-cli write schreiben.</translation>
    </message>
    <message>
        <source>list the participants of the bus, and look for encoders on a serial line</source>
        <translation>die Teilnehmer des Busses auflisten und Geber an einer seriellen Leitung suchen</translation>
    </message>
    <message>
        <source>Lists the participants of the bus in ring order, with their ID codes and words (16 bit each), and tells how the master stands.
The ID code tells the profile but not the make: that is named where the plan of the bus tells it.
Sends nothing on the bus.

On a serial line each address is asked for its serial number, and who answers for device code and
version. Nothing is written. Ctrl+C ends it, and lists what was found until then.

--save makes a project of it. With --project as well, what that project knows of devices
that are still there is taken along.</source>
        <translation>Listet die Teilnehmer des Busses in Ringreihenfolge auf, mit ID-Codes und Worten (je 16 Bit), und sagt, in
welchem Zustand der Master ist. Der ID-Code nennt das Profil, nicht den Hersteller: Dieser steht da, wenn
der Busplan ihn nennt. Sendet nichts auf dem Bus.

An einer seriellen Leitung wird jede Adresse nach ihrer Seriennummer gefragt, und wer antwortet, nach
Gerätecode und Version. Nichts wird geschrieben. Strg+C beendet es und listet auf, was bis dahin gefunden ist.

--save macht daraus ein Projekt. Zusammen mit --project wird übernommen, was jenes Projekt von Geräten
weiß, die noch da sind.</translation>
    </message>
    <message>
        <source>send what writes without asking</source>
        <translation>auch schreibende Anfragen ohne Rückfrage senden</translation>
    </message>
    <message>
        <source>Whether it was carried out is not known: read the value.</source>
        <translation>Ob es ausgeführt wurde, ist nicht bekannt: Den Wert auslesen.</translation>
    </message>
    <message>
        <source>%1 writes, and was not sent: there is nobody to ask. Add --yes.</source>
        <translation>%1 schreibt und wurde nicht gesendet: Es ist niemand da, der gefragt werden kann. --yes hinzufügen.</translation>
    </message>
    <message>
        <source>Send it?</source>
        <translation>Senden?</translation>
    </message>
    <message>
        <source>send typed requests over a serial line</source>
        <translation>eingetippte Anfragen über eine serielle Leitung senden</translation>
    </message>
    <message>
        <source>Sends each REQUEST once: the address as two hexadecimal digits, the command, and the data of a
write, as 05P or 03GP5200. Without one, requests are read from standard input, a line each, until
its end (Ctrl+D). What passes both ways is printed with its time, as text, as bytes, and in words;
with --json as one object in each line. No position is polled.

What writes is asked for first; where nobody can be asked, --yes is needed. In a pipe the first
request that is wrong, not answered, or refused for want of --yes is the last.</source>
        <translation>Sendet jede REQUEST einmal: die Adresse als zwei Hexziffern, den Befehl und beim Schreiben die Daten,
etwa 05P oder 03GP5200. Ohne REQUEST werden Anfragen von der Standardeingabe gelesen, je Zeile eine,
bis zu ihrem Ende (Strg+D). Was in beiden Richtungen läuft, wird mit Zeit ausgegeben, als Text, als Bytes
und in Worten; mit --json je Zeile als ein Objekt. Die Position wird nicht abgefragt.

Vor einer schreibenden Anfrage wird gefragt; wo niemand gefragt werden kann, ist --yes nötig. In einer Pipe
ist die erste Anfrage die letzte, die falsch ist, keine Antwort bekommt oder mangels --yes abgelehnt wird.</translation>
    </message>
    <message>
        <source>Encoders on a serial line have no velocity mode.</source>
        <translation>Geber an einer seriellen Leitung haben keinen Drehzahlbetrieb.</translation>
    </message>
    <message>
        <source>Encoders on a serial line have no words of process data. Send commands with codewheel-cli terminal.</source>
        <translation>Geber an einer seriellen Leitung haben keine Prozessdatenworte. Befehle mit codewheel-cli terminal senden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an answer to %2. A read is answered with its digits, a write with a bare line end (type CRLF), either with 03 or 05 where it is refused.</source>
        <translation>„%1“ ist keine Antwort auf %2. Ein Lesen wird mit seinen Ziffern beantwortet, ein Schreiben mit einem bloßen Zeilenende (CRLF eintippen), beides mit 03 oder 05, wenn es abgelehnt wird.</translation>
    </message>
    <message>
        <source>%1 is for words of process data; an encoder on a serial line has none. Leave it out.</source>
        <translation>%1 ist für Prozessdatenworte; ein Geber an einer seriellen Leitung hat keine. Weglassen.</translation>
    </message>
    <message>
        <source>An answer means nothing without its request. Give it with --other, as --other 05P.</source>
        <translation>Eine Antwort sagt ohne ihre Anfrage nichts. Diese mit --other angeben, etwa --other 05P.</translation>
    </message>
    <message>
        <source>A request needs no --other. Leave it out, or give --direction in to explain an answer.</source>
        <translation>Eine Anfrage braucht kein --other. Weglassen oder --direction in angeben, um eine Antwort zu erklären.</translation>
    </message>
    <message>
        <source>codewheel-cli sets up, watches and diagnoses absolute encoders on INTERBUS and on serial lines.</source>
        <translation>codewheel-cli richtet Absolutgeber am INTERBUS und an seriellen Leitungen ein, beobachtet sie und findet Fehler.</translation>
    </message>
    <message>
        <source>No encoder answers at %1 at %2 Bd. Check address, baud rate, wiring and supply; an RS-422 encoder also needs ST (pin 7) at +UB. codewheel-cli scan --all-rates looks for encoders.</source>
        <translation>Auf %1 antwortet mit %2 Bd kein Geber. Adresse, Baudrate, Verdrahtung und Versorgung prüfen; ein RS-422-Geber braucht auch ST (Pin 7) an +UB. codewheel-cli scan --all-rates sucht nach Gebern.</translation>
    </message>
    <message>
        <source>accepted by the encoder, not read back</source>
        <translation>vom Geber angenommen, nicht zurückgelesen</translation>
    </message>
    <message>
        <source>sent: it is not known whether the encoder has it</source>
        <translation>gesendet: ob der Geber es hat, ist nicht bekannt</translation>
    </message>
    <message>
        <source>not taken: the encoder has another value</source>
        <translation>nicht übernommen: Der Geber hat einen anderen Wert</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>nicht gesendet</translation>
    </message>
    <message>
        <source>What the encoder has is known as far as it is told above: connect again and read it.</source>
        <translation>Was der Geber hat, ist nur bekannt, soweit es oben steht: neu verbinden und auslesen.</translation>
    </message>
    <message>
        <source>The encoder does not answer any more.</source>
        <translation>Der Geber antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>The encoder answers at %1.</source>
        <translation>Der Geber antwortet auf %1.</translation>
    </message>
    <message>
        <source>Requests: %1. Answers: %2. Time-outs: %3. Retries: %4. Not answered: %5. Garbage bytes: %6. Late bytes: %7.</source>
        <translation>Anfragen: %1. Antworten: %2. Zeitüberschreitungen: %3. Wiederholungen: %4. Unbeantwortet: %5. Störbytes: %6. Verspätete Bytes: %7.</translation>
    </message>
    <message>
        <source>Answer time: %1 ms (median; shortest %2, longest %3).</source>
        <translation>Antwortzeit: %1 ms (Median; kürzeste %2, längste %3).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a format of a serial line. Give data bits (7, 8), parity (N, E, O) and stop bits (1, 2), as 8N2.</source>
        <translation>„%1“ ist kein Format einer seriellen Leitung. Datenbits (7, 8), Parität (N, E, O) und Stoppbits (1, 2) angeben, etwa 8N2.</translation>
    </message>
    <message>
        <source>A serial line has no setting &quot;%1&quot;. Its settings are: %2. Write them behind the port, as esc:ttyUSB0,baud=9600.</source>
        <translation>Eine serielle Leitung hat keine Einstellung „%1“. Ihre Einstellungen sind: %2. Sie stehen hinter dem Anschluss, etwa esc:ttyUSB0,baud=9600.</translation>
    </message>
    <message>
        <source>The setting %1 of the line cannot be &quot;%2&quot;. Give a whole number from %3 to %4.</source>
        <translation>Die Einstellung %1 der Leitung kann nicht „%2“ sein. Eine ganze Zahl von %3 bis %4 angeben.</translation>
    </message>
    <message>
        <source>Name the port of the serial line, as --link esc:ttyUSB0. %1</source>
        <translation>Den Anschluss der seriellen Leitung nennen, etwa --link esc:ttyUSB0. %1</translation>
    </message>
    <message>
        <source>The ports there are: %1.</source>
        <translation>Vorhandene Anschlüsse: %1.</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>an encoder with the serial number %1</source>
        <translation>ein Geber mit der Seriennummer %1</translation>
    </message>
    <message>
        <source>The encoder is at %1 now: PLACE %2.</source>
        <translation>Der Geber ist jetzt an %1: PLACE %2.</translation>
    </message>
    <message>
        <source>The encoder has %1 Bd now: give the link as ...,baud=%1.</source>
        <translation>Der Geber spricht jetzt mit %1 Bd: Die Verbindung als ...,baud=%1 angeben.</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>suspect: asked for again</source>
        <translation>verdächtig: noch einmal abgefragt</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>alarms and warnings</source>
        <translation>Alarme und Warnungen</translation>
    </message>
    <message>
        <source>The last address, %1, lies before the first, %2.</source>
        <translation>Die letzte Adresse, %1, liegt vor der ersten, %2.</translation>
    </message>
    <message>
        <source>Addresses asked: %1 of %2. Encoders found: %3.</source>
        <translation>Abgefragte Adressen: %1 von %2. Gefundene Geber: %3.</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>master</source>
        <translation>Master</translation>
    </message>
    <message>
        <source>No encoder answers. Check baud rate (--all-rates), wiring and supply; an RS-422 encoder also needs ST (pin 7) at +UB.</source>
        <translation>Kein Geber antwortet. Baudrate (--all-rates), Verdrahtung und Versorgung prüfen; ein RS-422-Geber braucht auch ST (Pin 7) an +UB.</translation>
    </message>
    <message>
        <source>The search was cancelled: what was found until then is listed.</source>
        <translation>Die Suche wurde abgebrochen: Aufgelistet ist, was bis dahin gefunden war.</translation>
    </message>
    <message>
        <source>serial line: at 19200, 9600 and 4800 Bd, not at that of the link alone</source>
        <translation>serielle Leitung: mit 19200, 9600 und 4800 Bd, nicht nur mit der Baudrate der Verbindung</translation>
    </message>
    <message>
        <source>serial line: ask at the master address first, where one encoder is alone</source>
        <translation>serielle Leitung: zuerst die Masteradresse abfragen, wenn nur ein Geber an der Leitung ist</translation>
    </message>
    <message>
        <source>serial line: the first address asked (01)</source>
        <translation>serielle Leitung: die erste abgefragte Adresse (01)</translation>
    </message>
    <message>
        <source>serial line: the last address asked (1F)</source>
        <translation>serielle Leitung: die letzte abgefragte Adresse (1F)</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>%1: nothing was stored.</source>
        <translation>%1: Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Shows what the encoders named, or all, are known to have beside what the project wants, with the
words; asks; writes to one after the other, and tells what became of each value. What is already
there is not written: an encoder that can be read is read first. An encoder of which one value
cannot be written is not written at all, nor is one that is not the project&apos;s: its place may have
another number now (see &quot;compare&quot;). Exit code 1 if an encoder has not got all of it.</source>
        <translation>Zeigt, was von den genannten oder von allen Gebern bekannt ist, neben dem, was das Projekt wünscht, mit
den Worten; fragt; schreibt in einen nach dem anderen und sagt, was aus jedem Wert wurde. Was schon
vorhanden ist, wird nicht geschrieben: Ein Geber, der sich auslesen lässt, wird zuerst ausgelesen. Ein
Geber, in den sich ein Wert nicht schreiben lässt, wird gar nicht beschrieben, und auch keiner, der
nicht der des Projekts ist: Sein Platz kann jetzt eine andere Nummer haben (siehe „compare“).
Rückgabewert 1, wenn ein Geber nicht alles bekommen hat.</translation>
    </message>
    <message>
        <source>With --dry-run nothing is written, so there is nothing to report. Leave out --report or --dry-run.</source>
        <translation>Mit --dry-run wird nichts geschrieben, also gibt es nichts zu berichten. --report oder --dry-run weglassen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; ends in .pdf. What was written is saved as a web page (.html), or as text under any other name.</source>
        <translation>„%1“ endet auf .pdf. Was geschrieben wurde, wird als Webseite (.html) gespeichert, unter jedem anderen Namen als Text.</translation>
    </message>
    <message>
        <source>save what was written where: HTML where the name ends in .html, else text; a FILE that is there is replaced with --yes only</source>
        <translation>speichern, was wohin geschrieben wurde: als HTML, wenn der Name auf .html endet, sonst als Text; eine vorhandene FILE wird nur mit --yes ersetzt</translation>
    </message>
    <message>
        <source>whether an error of the encoder ends the sequence (stop)</source>
        <translation>ob ein Fehler des Gebers die Sequenz beendet (stop)</translation>
    </message>
    <message>
        <source>Sends words as they are, one after the other, and prints a row for each change of OUT or IN.
A parameter word stands until the encoder has confirmed it, run (80000000) until it shows a position
or an error, a read-out until it answers; any other word stands for 3 cycles, 40000000 until the
position has followed. --hold says otherwise. The FRABA preset (60000000) stands for one cycle,
whatever --hold says: it acts in each. An error of the encoder ends the sequence; with
--after-error go-on the next word is sent, so that a way out of it can be tried, and the exit code is
1 only where the last word was answered by an error, or the encoder is left in one. Words are
hexadecimal, as the manuals print them.</source>
        <translation>Sendet Worte unverändert nacheinander und gibt für jede Änderung von OUT oder IN eine Zeile aus.
Ein Parameterwort steht, bis der Geber es quittiert hat, Run (80000000), bis er eine Position oder
einen Fehler zeigt, ein Auslesen, bis er antwortet; jedes andere Wort steht 3 Zyklen, 40000000, bis
die Position gefolgt ist. Mit --hold gilt anderes. Der FRABA-Preset (60000000) steht einen Zyklus, was
immer --hold sagt: Er wirkt in jedem. Ein Fehler des Gebers beendet die Sequenz; mit
--after-error go-on wird das nächste Wort gesendet, damit sich ein Weg aus dem Fehler probieren lässt,
und der Rückgabewert ist nur dann 1, wenn auf das letzte Wort ein Fehler kam oder der Geber im Fehler
bleibt. Worte sind hexadezimal, wie in den Handbüchern.</translation>
    </message>
    <message>
        <source>set by the encoder itself, with the steps</source>
        <translation>vom Geber selbst mit den Schritten gesetzt</translation>
    </message>
    <message>
        <source>the key on the label of the encoder: it says how many bits a position has</source>
        <translation>der Schlüssel auf dem Typenschild des Gebers: Er sagt, wie viele Bits eine Position hat</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; is not that of %2. It may be that of: %3.</source>
        <translation>Der Schlüssel „%1“ gehört nicht zu %2. Er kann gehören zu: %3.</translation>
    </message>
    <message>
        <source>Reads the parameters named, or all that can be read but the registers of the bus chip, which are
read by name: opc-register-0 to opc-register-15. While it is read, the encoder shows no position.
An encoder without read-out (devices tells which) is not asked: exit code 1.
An encoder on a serial line also has a version, which is text.</source>
        <translation>Liest die genannten Parameter oder alle lesbaren außer den Registern des Busbausteins; diese werden mit
Namen gelesen: opc-register-0 bis opc-register-15. Beim Lesen zeigt der Geber keine Position.
Ein Geber ohne Auslesen (siehe devices) wird nicht gefragt: Rückgabewert 1.
Ein Geber an einer seriellen Leitung hat auch eine Version (version), die Text ist.</translation>
    </message>
    <message>
        <source>At %1 no encoder tells its serial number twice the same: several may answer at once. The address is for an encoder that is alone on its line. codewheel-cli scan finds the addresses of all.</source>
        <translation>An %1 meldet kein Geber zweimal dieselbe Seriennummer: Vielleicht antworten mehrere zugleich. Die Adresse ist für einen Geber, der allein an seiner Leitung ist. codewheel-cli scan findet die Adressen aller.</translation>
    </message>
    <message>
        <source>This was done:</source>
        <translation>Das wurde erledigt:</translation>
    </message>
    <message>
        <source>%1 was sent, and answered.</source>
        <translation>%1 wurde gesendet und beantwortet.</translation>
    </message>
    <message>
        <source>%1 was sent: whether it was carried out is not known.</source>
        <translation>%1 wurde gesendet: Ob es ausgeführt wurde, ist unbekannt.</translation>
    </message>
    <message>
        <source>Nothing was sent: what would be sent could not be shown.</source>
        <translation>Nichts gesendet: Was gesendet würde, konnte nicht angezeigt werden.</translation>
    </message>
    <message>
        <source>export: replace the file if it is there</source>
        <translation>export: die Datei ersetzen, falls sie vorhanden ist</translation>
    </message>
    <message>
        <source>Saved in %1: entries of the ledger: %2.</source>
        <translation>Gespeichert in %1: Einträge des Verzeichnisses: %2.</translation>
    </message>
    <message>
        <source>Imported into %1: new entries: %2; known already: %3.</source>
        <translation>Übernommen in %1: neue Einträge: %2; schon bekannt: %3.</translation>
    </message>
    <message>
        <source>The EEPROM writes of this call are not entered in the ledger.</source>
        <translation>Die EEPROM-Schreibvorgänge dieses Aufrufs sind nicht im Verzeichnis eingetragen.</translation>
    </message>
    <message>
        <source>Reads all that can be read of the encoders named, or of all, and keeps it in the project, with its
evidence and time. While one on INTERBUS is read, it shows no position. Of an encoder that cannot be
read what is known is kept; what nobody knows stays unknown. With --cams each cam program is read
in the cam mode of its own; leaving one that was changed before costs an EEPROM write.
Nothing is stored of a place where another encoder may stand than the project has (see
&quot;compare&quot;): exit code 1. The file that was there is kept as PROJECT~.</source>
        <translation>Liest alles, was sich von den genannten oder von allen Gebern lesen lässt, und legt es mit Herkunft
und Zeit im Projekt ab. Solange ein Geber am INTERBUS gelesen wird, zeigt er keine Position. Von einem,
der sich nicht auslesen lässt, wird abgelegt, was bekannt ist; Unbekanntes bleibt unbekannt. Mit
--cams wird jedes Nockenprogramm in seinem eigenen Nockenbetrieb gelesen; ein vorher geändertes zu
verlassen kostet einen EEPROM-Schreibvorgang. Von einem Platz, an dem ein anderer Geber stehen kann
als im Projekt, wird nichts abgelegt (siehe „compare“): Rückgabewert 1. Die vorige Datei bleibt als
PROJECT~ erhalten.</translation>
    </message>
    <message>
        <source>code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the way to the encoders: training (the default), the simulated buses; project, all buses of the project; or SCHEME:WHERE, with settings behind it, as in esc:ttyUSB0,baud=9600</source>
        <translation>der Weg zu den Gebern: training (ohne Angabe), die simulierten Busse; project, alle Busse des Projekts; oder SCHEME:WHERE mit Einstellungen dahinter, etwa esc:ttyUSB0,baud=9600</translation>
    </message>
    <message>
        <source>the addresses of encoders as two hexadecimal digits, as 05</source>
        <translation>die Adressen von Gebern als zwei Hexziffern, etwa 05</translation>
    </message>
    <message>
        <source>training, the simulated buses</source>
        <translation>training, die simulierten Busse</translation>
    </message>
    <message>
        <source>project, all buses of the project</source>
        <translation>project, alle Busse des Projekts</translation>
    </message>
    <message>
        <source>There is no link &quot;%1&quot;. The links are: %2.</source>
        <translation>Es gibt keine Verbindung „%1“. Die Verbindungen sind: %2.</translation>
    </message>
    <message>
        <source>Say with protocol= what is spoken at %1. There is: %2.</source>
        <translation>Mit protocol= angeben, was an %1 gesprochen wird. Es gibt: %2.</translation>
    </message>
    <message>
        <source>Several buses may have %1. Give one of these: %2.</source>
        <translation>Mehrere Busse können %1 haben. Einen davon angeben: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a station on a bus that the link does not lead to.</source>
        <translation>„%1“ ist eine Station an einem Bus, zu dem die Verbindung nicht führt.</translation>
    </message>
    <message>
        <source>%1 is a place on a bus that the link does not lead to (%2). Places there are: %3.</source>
        <translation>%1 ist ein Platz an einem Bus, zu dem die Verbindung nicht führt (%2). Plätze dort sind: %3.</translation>
    </message>
    <message>
        <source>The link leads to no bus &quot;%1&quot;. The buses are: %2.</source>
        <translation>Die Verbindung führt zu keinem Bus „%1“. Die Busse sind: %2.</translation>
    </message>
    <message>
        <source>The link leads to no bus of this kind: %1.</source>
        <translation>Die Verbindung führt zu keinem Bus dieser Art: %1.</translation>
    </message>
    <message>
        <source>on this bus, as the project calls it, where there are several</source>
        <translation>an diesem Bus, wie das Projekt ihn nennt, wenn es mehrere gibt</translation>
    </message>
    <message>
        <source>interbus:training, the simulated ring alone</source>
        <translation>interbus:training, der simulierte Ring allein</translation>
    </message>
    <message>
        <source>The project links &quot;%1&quot; by &quot;%2&quot;: this program has no such link.</source>
        <translation>Das Projekt verbindet „%1“ über „%2“: Eine solche Verbindung hat dieses Programm nicht.</translation>
    </message>
    <message>
        <source>The project has no port for &quot;%1&quot; yet. Choose one in the window, or name it, as --link esc:ttyUSB0.</source>
        <translation>Das Projekt hat für „%1“ noch keinen Anschluss. Einen im Fenster wählen oder nennen, etwa --link esc:ttyUSB0.</translation>
    </message>
    <message>
        <source>Lays the devices the project has configured beside those that are connected and tells line by line
what is the same, differs, is missing, additional or moved; exit code 1 if anything differs. The
make is not compared: the bus does not tell it. On a serial line the encoders of the project are
asked who they are; one that does not answer is missing.
Sends nothing to a ring.</source>
        <translation>Stellt die im Projekt geplanten Teilnehmer den angeschlossenen gegenüber und sagt Zeile für Zeile, was
gleich ist, abweicht, fehlt, zusätzlich da oder versetzt ist; Rückgabewert 1, wenn etwas abweicht. Der
Hersteller wird nicht verglichen: Der Bus nennt ihn nicht. An einer seriellen Leitung werden die
Geber des Projekts gefragt, wer sie sind; einer, der nicht antwortet, fehlt.
Sendet nichts an einen Ring.</translation>
    </message>
    <message>
        <source>Not compared, since the link does not lead there, or it cannot be reached: %1.</source>
        <translation>Nicht verglichen, weil die Verbindung nicht dorthin führt oder nicht erreichbar ist: %1.</translation>
    </message>
    <message>
        <source>The call names two projects: %1 and %2. Leave --project out.</source>
        <translation>Der Aufruf nennt zwei Projekte: %1 und %2. --project weglassen.</translation>
    </message>
    <message>
        <source>The project has several devices at the station &quot;%1&quot;. Give one of these: %2.</source>
        <translation>Das Projekt hat mehrere Teilnehmer an der Station „%1“. Einen davon angeben: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the name of one bus and the number of another. Rename it.</source>
        <translation>„%1“ ist der Name eines Busses und die Nummer eines anderen. Den ersten umbenennen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a station of the project, and a place on a bus. Give the number of the bus and the place: %2.</source>
        <translation>„%1“ ist eine Station des Projekts und ein Platz an einem Bus. Nummer des Busses und Platz angeben: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a bus of this kind: %2. There is: %3.</source>
        <translation>„%1“ ist kein Bus dieser Art: %2. Es gibt: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not spoken at %2. What protocol= can name there: %3.</source>
        <translation>„%1“ wird an %2 nicht gesprochen. Mögliche Angaben für protocol= sind: %3.</translation>
    </message>
    <message>
        <source>The link leads to several buses. Name one with %1: %2.</source>
        <translation>Die Verbindung führt zu mehreren Bussen. Einen mit %1 nennen: %2.</translation>
    </message>
    <message>
        <source>the ring of the fault plan, as the project calls it, where there are several</source>
        <translation>der Ring des Fehlerplans, wie ihn das Projekt nennt, wenn es mehrere gibt</translation>
    </message>
    <message>
        <source>The link %1 has no settings. Leave &quot;%2&quot; out.</source>
        <translation>Die Verbindung %1 hat keine Einstellungen. „%2“ weglassen.</translation>
    </message>
    <message>
        <source>%1 is for a bus that the link does not lead to: %2. Leave it out.</source>
        <translation>%1 ist für einen Bus, zu dem die Verbindung nicht führt: %2. Weglassen.</translation>
    </message>
    <message>
        <source>of this device; &quot;bus&quot;: of none</source>
        <translation>von diesem Teilnehmer; „bus“: von keinem</translation>
    </message>
    <message>
        <source>of this bus and its devices: its number, or its name in the project</source>
        <translation>von diesem Bus und seinen Teilnehmern: seine Nummer oder sein Name im Projekt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a bus. Write its number, or its name with --project.</source>
        <translation>„%1“ ist kein Bus. Seine Nummer schreiben, oder seinen Namen mit --project.</translation>
    </message>
    <message>
        <source>Give --place or --bus, not both. A place on another bus is written as 3/1.0.</source>
        <translation>Entweder --place oder --bus angeben. Ein Platz an einem anderen Bus wird als 3/1.0 geschrieben.</translation>
    </message>
    <message>
        <source>Name the line before the request, as %1/%2.</source>
        <translation>Die Leitung vor der Anfrage nennen, wie %1/%2.</translation>
    </message>
    <message>
        <source>%1, those of one kind alone</source>
        <translation>%1, nur die einer Art</translation>
    </message>
    <message>
        <source>The link &quot;%1&quot; needs a project. Name it with --project FILE.</source>
        <translation>Die Verbindung „%1“ braucht ein Projekt. Dieses mit --project FILE nennen.</translation>
    </message>
    <message>
        <source>The project has no buses for the link &quot;%1&quot;.</source>
        <translation>Das Projekt hat keine Busse für die Verbindung „%1“.</translation>
    </message>
    <message>
        <source>The bus &quot;%1&quot; differs from the project. See codewheel-cli compare.</source>
        <translation>Der Bus „%1“ weicht vom Projekt ab. Siehe codewheel-cli compare.</translation>
    </message>
    <message>
        <source>%1 has nothing stored of its encoders: there is nothing to write.</source>
        <translation>In %1 ist von seinen Gebern nichts abgelegt: Es gibt nichts zu schreiben.</translation>
    </message>
    <message>
        <source>%1 wants nothing of its encoders: there is nothing to write.</source>
        <translation>%1 wünscht von seinen Gebern nichts: Es gibt nichts zu schreiben.</translation>
    </message>
    <message>
        <source>Whether the position was set is not known: read it.</source>
        <translation>Ob die Position gesetzt wurde, ist nicht bekannt: Die Position auslesen.</translation>
    </message>
    <message>
        <source>Not searched any more: the search was cancelled.</source>
        <translation>Nicht mehr durchsucht: Die Suche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>As an option: --beyond-eeprom-limit %1.</source>
        <translation>Als Option: --beyond-eeprom-limit %1.</translation>
    </message>
    <message>
        <source>The search was cancelled: until then no encoder had answered.</source>
        <translation>Die Suche wurde abgebrochen: Bis dahin hatte kein Geber geantwortet.</translation>
    </message>
    <message>
        <source>Position: it is not known whether it was set to %1.</source>
        <translation>Position: Es ist nicht bekannt, ob sie auf %1 gesetzt wurde.</translation>
    </message>
    <message>
        <source>The project has the bus &quot;%1&quot;, but the link does not lead to it. The buses of the link are: %2. --link project leads to all of the project.</source>
        <translation>Das Projekt hat den Bus „%1“, aber --link führt nicht zu ihm. Die Busse der Verbindung sind: %2. --link project führt zu allen des Projekts.</translation>
    </message>
    <message>
        <source>Standard output cannot be written: %1.</source>
        <translation>Auf die Standardausgabe kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>No bus of the project is at %1: what the project says of its encoders does not count for it.</source>
        <translation>An %1 ist kein Bus des Projekts: Was im Projekt von seinen Gebern steht, gilt dort nicht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a bus of the project. Its buses are: %2.</source>
        <translation>„%1“ ist kein Bus des Projekts. Seine Busse sind: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a place. Write it as 1.0, with its bus as 3/1.0, or with the name of the bus and --project; or write bus.</source>
        <translation>„%1“ ist kein Platz. Als 1.0 schreiben, mit seinem Bus als 3/1.0 oder mit dem Namen des Busses und --project; oder bus.</translation>
    </message>
    <message>
        <source>The encoder at %1 reports the serial number %3, and --serial is %2. Nothing was written, and the project is unchanged: correct --serial, or leave it out.</source>
        <translation>Der Geber an %1 meldet die Seriennummer %3, aber --serial ist %2. Nichts wurde geschrieben, und das Projekt ist unverändert: --serial berichtigen oder weglassen.</translation>
    </message>
    <message>
        <source>Saved as a new bus, beside those of the project: %1.</source>
        <translation>Als neuer Bus gespeichert, neben denen des Projekts: %1.</translation>
    </message>
    <message>
        <source>PLACE is the device number of an encoder, segment.position: 1.0; on a serial line its address,
two hexadecimal digits: 12, or esc:12; or its station in the project. Where several buses have it,
BUS/PLACE names one, BUS being its name in the project, else Ring or Line, or its number. Numbers
are decimal unless they are written 0x.. or ..h; a WORD is always hexadecimal, as the manuals print it.

Each call has a new training bus, which always starts the same: 1.0 FRABA K3 that stands
still, 2.0 Baumer K3 that turns at 10 rpm, 3.0 FRABA K1, 4.0 FRABA K2, 5.0 TR LA-66 on a rod,
6.0 bus terminal and, behind it, 6.1 FRABA K3 on Loop 2; and a serial line with the Kübler
encoders 03, 05 and 12. What one call wrote, the next one does not find.

Exit code: 0 done; 1 not done, not known, or done and not told; 2 bad input.
codewheel-cli COMMAND --help explains a command.</source>
        <translation>PLACE ist die Teilnehmernummer eines Gebers, Segment.Position: 1.0; an einer seriellen Leitung seine
Adresse, zwei Hexziffern: 12, oder esc:12; oder seine Station im Projekt. Wo mehrere Busse ihn haben,
nennt BUS/PLACE einen davon; BUS ist sein Name im Projekt, sonst Ring oder Line, oder seine Nummer.
Zahlen sind dezimal, außer sie sind 0x.. oder ..h geschrieben; ein WORD ist immer hexadezimal, wie die
Handbücher es drucken.

Jeder Aufruf hat einen neuen Übungsbus, der immer gleich beginnt: 1.0 FRABA K3, der stillsteht,
2.0 Baumer K3, der mit 10 U/min dreht, 3.0 FRABA K1, 4.0 FRABA K2, 5.0 TR LA-66 an einem Stab,
6.0 Busklemme und dahinter 6.1 FRABA K3 an Loop 2; und eine serielle Leitung mit den Kübler-Gebern
03, 05 und 12. Was ein Aufruf schrieb, findet der nächste nicht vor.

Rückgabewert: 0 erledigt; 1 nicht erledigt, unbekannt, oder erledigt, aber nicht gemeldet;
2 falsche Eingabe.
codewheel-cli COMMAND --help erklärt einen Befehl.</translation>
    </message>
    <message>
        <source>What is written to the address 00 goes into the EEPROM of every encoder of the line, and it is not known which there are. Nothing was sent. Write to each by its own address (codewheel-cli scan finds them), or name the project that has them with --project.</source>
        <translation>Was an die Adresse 00 geschrieben wird, geht in das EEPROM jedes Gebers der Leitung, und es ist nicht bekannt, welche da sind. Nichts wurde gesendet. In jeden unter seiner eigenen Adresse schreiben (codewheel-cli scan findet sie) oder mit --project das Projekt nennen, das sie hat.</translation>
    </message>
    <message>
        <source>No answer comes from %1 at %2 Bd, but bytes that are no answers: %3 until now. Either the answers come late (time-out=500 behind the port waits longer), or another baud rate or format is needed (codewheel-cli scan --all-rates tries the rates), or the wiring is wrong or disturbed (A and B exchanged, no termination), or a device on the line speaks another protocol.</source>
        <translation>Von %1 kommt bei %2 Bd keine Antwort; es kommen aber Bytes, die keine Antworten sind: bisher %3. Entweder kommen die Antworten zu spät (time-out=500 hinter dem Anschluss wartet länger), oder es ist eine andere Baudrate oder ein anderes Format nötig (codewheel-cli scan --all-rates probiert die Baudraten), oder die Verdrahtung ist falsch oder gestört (A und B vertauscht, kein Abschluss), oder ein Gerät an der Leitung spricht ein anderes Protokoll.</translation>
    </message>
    <message>
        <source>%1 is in use: the project gives it to the bus &quot;%2&quot; too. A port is for one bus. Choose another one for it.</source>
        <translation>%1 ist belegt: Im Projekt hat auch der Bus „%2“ diesen Anschluss. Ein Anschluss ist nur für einen Bus. Einen anderen wählen.</translation>
    </message>
    <message>
        <source>Bytes come that are no answers: %1 until now. The answers may come late (time-out=500 behind the port waits longer), the baud rate or the format may be another one, the wiring wrong or disturbed, or a device on the line speaks another protocol.</source>
        <translation>Es kommen Bytes, die keine Antworten sind: bisher %1. Entweder kommen die Antworten zu spät (time-out=500 hinter dem Anschluss wartet länger), oder Baudrate oder Format sind andere, oder die Verdrahtung ist falsch oder gestört, oder ein Gerät an der Leitung spricht ein anderes Protokoll.</translation>
    </message>
    <message>
        <source>esc:training, the simulated line alone; esc:PORT, a serial line with Kübler encoders, as esc:ttyUSB0,baud=9600</source>
        <translation>esc:training, die simulierte Leitung allein; esc:PORT, eine serielle Leitung mit Kübler-Gebern, etwa esc:ttyUSB0,baud=9600</translation>
    </message>
    <message>
        <source>how long a word stays that nothing acknowledges (3)</source>
        <translation>wie lange ein Wort steht, das nichts quittiert (3)</translation>
    </message>
    <message>
        <source>This is lost: %1.</source>
        <translation>Verloren gehen: %1.</translation>
    </message>
    <message>
        <source>treat the encoder as this one: a name from &quot;devices&quot;, or the key on its label</source>
        <translation>der Geber gilt als dieser: ein Name aus „devices“ oder der Schlüssel auf dem Typenschild</translation>
    </message>
    <message>
        <source>whether a description file is valid</source>
        <translation>ob eine Beschreibungsdatei in Ordnung ist</translation>
    </message>
    <message>
        <source>%1 is valid: %2 (%3)</source>
        <translation>%1 ist in Ordnung: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 is only on the label of the %2: it is neither read nor written over the bus. There are: %3.</source>
        <translation>%1 steht nur auf dem Typenschild (%2): wird über den Bus weder gelesen noch geschrieben. Es gibt: %3.</translation>
    </message>
    <message>
        <source>Reads the encoder at FROM, which hides its position for some cycles, and writes its values to
encoders of the same kind, as &quot;transfer&quot; does. The zero offset is not taken along: it belongs to
the way an encoder is mounted. With --cams each cam program of FROM is read in the cam mode of its
own; leaving one that was changed before costs an EEPROM write.</source>
        <translation>Liest den Geber an FROM aus, der dabei für einige Zyklen keine Position zeigt, und schreibt seine Werte
wie „transfer“ in Geber derselben Art. Die Nullpunkt-Verschiebung wird nicht mitgenommen: Sie hängt vom
Anbau des Gebers ab. Mit --cams wird jedes Nockenprogramm von FROM in seinem eigenen Nockenbetrieb
gelesen; ein vorher geändertes zu verlassen kostet einen EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>store in a project what encoders have</source>
        <translation>die Werte der Geber in einem Projekt ablegen</translation>
    </message>
    <message>
        <source>start no other encoder after one has refused</source>
        <translation>keinen weiteren Geber beginnen, wenn einer abgelehnt hat</translation>
    </message>
    <message>
        <source>EEPROM writes: %1. Afterwards: %2.</source>
        <translation>EEPROM-Schreibvorgänge: %1. Danach: %2.</translation>
    </message>
    <message>
        <source>with this text anywhere in the line</source>
        <translation>mit diesem Text irgendwo in der Zeile</translation>
    </message>
    <message>
        <source>write all that match to FILE, .csv or .html</source>
        <translation>alle passenden in FILE schreiben, .csv oder .html</translation>
    </message>
    <message>
        <source>No messages are stored in %1.</source>
        <translation>In %1 sind keine Meldungen aufbewahrt.</translation>
    </message>
    <message>
        <source>list or export the stored messages</source>
        <translation>die aufbewahrten Meldungen auflisten oder exportieren</translation>
    </message>
    <message>
        <source>%1 is not treated as &quot;%2&quot; of the project: there is no such description, or it is for another device code.</source>
        <translation>%1 gilt nicht als „%2“ des Projekts: Es gibt keine solche Beschreibung, oder sie hat einen anderen Gerätecode.</translation>
    </message>
    <message>
        <source>ask the encoders of the bus what they have; hides their positions meanwhile</source>
        <translation>die Geber am Bus auslesen; solange zeigen sie keine Position</translation>
    </message>
    <message>
        <source>Shows what is known of the parameters, what they are to become, and the words for it; asks; writes them
in the order given, and tells by which evidence they are there. What the encoder already has is not
written again, unless --all is given: it is read first where that is possible, else it is what was
written from here. Where nobody can be asked, --yes is needed: without it nothing is sent, exit code 2.

Parameters: steps revolutions direction coding preset zero-offset offset measuring-range; of a linear
encoder direction measuring-length external-preset; as far as the encoder has them (devices NAME).
A VALUE is a number or a name: 255, 0xFF, FFh, cw.</source>
        <translation>Zeigt, was von den Parametern bekannt ist, was sie werden sollen und die Worte dafür; fragt; schreibt
sie in der angegebenen Reihenfolge und sagt, wodurch belegt ist, dass sie wirken. Was der Geber schon
hat, wird nicht noch einmal geschrieben, außer mit --all: Wo es geht, wird er zuerst ausgelesen, sonst
gilt, was von hier geschrieben wurde. Wo niemand gefragt werden kann, ist --yes nötig: Sonst wird nichts
gesendet, Rückgabewert 2.

Parameter: steps revolutions direction coding preset zero-offset offset measuring-range; bei einem
Lineargeber direction measuring-length external-preset; soweit der Geber sie hat (devices NAME).
VALUE ist eine Zahl oder ein Name: 255, 0xFF, FFh, cw.</translation>
    </message>
    <message>
        <source>the new encoder: a name of &quot;devices&quot;; else it is like the previous one</source>
        <translation>der neue Geber: ein Name aus „devices“; sonst ist er wie der vorige</translation>
    </message>
    <message>
        <source>It fits: as far as the project shows, it is like the previous one.</source>
        <translation>Er passt: Soweit aus dem Projekt bekannt, ist er wie der vorige.</translation>
    </message>
    <message>
        <source>give a new encoder the values and the position of the previous one</source>
        <translation>einem neuen Geber Werte und Position des vorigen geben</translation>
    </message>
    <message>
        <source>No earlier values of %1 are kept for a write at %2. See codewheel-cli restore %1 --list.</source>
        <translation>Um %2 wurde nichts an %1 geschrieben, dessen vorige Werte aufbewahrt sind. Siehe codewheel-cli restore %1 --list.</translation>
    </message>
    <message>
        <source>No stored message matches.</source>
        <translation>Keine der aufbewahrten Meldungen passt dazu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice. Give it once.</source>
        <translation>„%1“ steht zweimal da. Einmal angeben.</translation>
    </message>
    <message>
        <source>Nothing was written to any encoder.</source>
        <translation>Es wurde in keinen Geber etwas geschrieben.</translation>
    </message>
    <message>
        <source>Tells what a 32-bit word means to an encoder. Every word gets an answer. What is not told
(mode, coding, the word the other way) widens it to all meanings the word can have.
A K1 or K2 counts as the standard one, unless its --label tells otherwise.

Of an encoder on a serial line it explains a request (03GP00005200), or, with --other REQUEST,
the answer to it: its digits, or CRLF for a bare line end. Of several lines of the link it goes by
the one named before the request (&quot;Gate 2/05P&quot;), else by the only one that has its address.

Needs no bus and sends nothing.</source>
        <translation>Sagt, was ein 32-Bit-Wort für einen Geber bedeutet. Jedes Wort bekommt eine Antwort. Was nicht
angegeben ist (Betriebsart, Codierung, Wort der Gegenrichtung), erweitert sie auf alle Bedeutungen,
die das Wort haben kann. Ein K1 oder K2 gilt als Standardgeber, wenn --label nichts anderes sagt.

Bei einem Geber an einer seriellen Leitung erklärt es eine Anfrage (03GP00005200) oder, mit
--other REQUEST, die Antwort darauf: ihre Ziffern, oder CRLF für ein bloßes Zeilenende. Von mehreren
Leitungen der Verbindung gilt die, die vor der Anfrage steht („Gate 2/05P“), sonst die einzige, die
ihre Adresse hat.

Braucht keinen Bus und sendet nichts.</translation>
    </message>
    <message>
        <source>The bus &quot;%1&quot; differs from the project, so &quot;%2&quot; may be elsewhere. See codewheel-cli compare, or give the device number.</source>
        <translation>Der Bus „%1“ weicht vom Projekt ab, also kann „%2“ woanders stehen. Siehe codewheel-cli compare, oder die Teilnehmernummer angeben.</translation>
    </message>
    <message>
        <source>%1: nothing answers there. The encoders that are planned on it stay in the project.</source>
        <translation>%1: Dort antwortet niemand. Die Geber, die dort geplant sind, bleiben im Projekt.</translation>
    </message>
    <message>
        <source>Nobody has said which encoders the bus &quot;%1&quot; has: it is left out. Name their places, or give a project that has them. codewheel-cli scan finds them.</source>
        <translation>Welche Geber der Bus „%1“ hat, ist nicht angegeben: Er bleibt weg. Ihre Plätze angeben oder ein Projekt, das sie hat. codewheel-cli scan findet sie.</translation>
    </message>
    <message>
        <source>There is no encoder to record. Name a PLACE.</source>
        <translation>Es gibt keinen Geber zum Aufzeichnen. Einen PLACE angeben.</translation>
    </message>
    <message>
        <source>The encoder at %1 shows no position: the trigger cannot come before it does. If its make is not known, --device names it.</source>
        <translation>Der Geber an %1 zeigt keine Position: Solange kann der Trigger nicht kommen. Ist sein Hersteller unbekannt, nennt ihn --device.</translation>
    </message>
    <message>
        <source>Recording into %1: %2.</source>
        <translation>Aufgezeichnet wird in %1: %2.</translation>
    </message>
    <message>
        <source>It begins with %1.</source>
        <translation>Beginn mit %1.</translation>
    </message>
    <message>
        <source>It takes %1.</source>
        <translation>Dauer: %1.</translation>
    </message>
    <message>
        <source>Ctrl+C ends it.</source>
        <translation>Mit Strg+C endet es.</translation>
    </message>
    <message>
        <source>Not everything is in %1: it could not be written until the end.</source>
        <translation>In %1 steht nicht alles: Sie ließ sich nicht bis zum Ende schreiben.</translation>
    </message>
    <message>
        <source>record what encoders show, at once or when something happens</source>
        <translation>aufzeichnen, was Geber zeigen, sofort oder wenn etwas geschieht</translation>
    </message>
    <message>
        <source>The trigger has come. It is recorded now.</source>
        <translation>Der Trigger ist gekommen. Jetzt wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>The recording is written again.</source>
        <translation>Die Aufzeichnung wird wieder geschrieben.</translation>
    </message>
    <message>
        <source>Values are lost from now on: more wait to be written than there is memory for. The recording has a gap in their place.</source>
        <translation>Ab jetzt gehen Werte verloren: Auf das Schreiben warten mehr, als Speicher da ist. An ihrer Stelle hat die Aufzeichnung eine Lücke.</translation>
    </message>
    <message>
        <source>The recording goes on, with a gap until the link is back.</source>
        <translation>Die Aufzeichnung geht weiter, mit einer Lücke, bis die Verbindung wieder da ist.</translation>
    </message>
    <message>
        <source>The link to the bus &quot;%1&quot; is back.</source>
        <translation>Die Verbindung zum Bus „%1“ ist wieder da.</translation>
    </message>
    <message>
        <source>Waiting for the trigger: %1</source>
        <translation>Warten auf den Trigger: %1</translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <translation>Aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>limit reached in %1</source>
        <translation>Grenze erreicht in %1</translation>
    </message>
    <message>
        <source>disk full in %1</source>
        <translation>Platte voll in %1</translation>
    </message>
    <message>
        <source>lost values: %1</source>
        <translation>verlorene Werte: %1</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; waits for a bit or a value of a bus. Name one of its encoders.</source>
        <translation>„%1“ wartet auf ein Bit oder einen Wert eines Busses. Einen seiner Geber angeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; waits for a value that no encoder has. There are position, speed, in, out and cams.</source>
        <translation>„%1“ wartet auf einen Wert, den kein Geber hat. Es gibt position, speed, in, out und cams.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; waits for a bit that does not exist. in and out have the bits 0 to 31, cams has 0 to 7.</source>
        <translation>„%1“ wartet auf ein Bit, das es nicht gibt. in und out haben die Bits 0 bis 31, cams hat 0 bis 7.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no number to compare with. A position is a whole number of steps; a speed is in steps per second, with up to three decimals behind a point.</source>
        <translation>„%1“ hat keine Zahl zum Vergleichen. Eine Position ist eine ganze Zahl von Schritten; eine Geschwindigkeit steht in Schritten je Sekunde, mit bis zu drei Stellen nach einem Punkt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a trigger. Write a bit as 1.0/in.25 (becomes 1) or 1.0/in.25=0, a threshold in quotation marks as &quot;1.0/position&gt;1000&quot;, or a message as fault or 1.0/fault.</source>
        <translation>„%1“ ist kein Trigger. Ein Bit als 1.0/in.25 (wird 1) oder 1.0/in.25=0 schreiben, eine Schwelle in Anführungszeichen als &quot;1.0/position&gt;1000&quot;, eine Meldung als fault oder 1.0/fault.</translation>
    </message>
    <message>
        <source>The encoder at %1 has no %2.</source>
        <translation>Der Geber an %1 hat kein %2.</translation>
    </message>
    <message>
        <source>the file to make, usually named .cwrec; there must be none of that name</source>
        <translation>die Datei, die angelegt wird, meist mit .cwrec am Ende; es darf sie noch nicht geben</translation>
    </message>
    <message>
        <source>how long to record; without: until Ctrl+C</source>
        <translation>wie lange aufgezeichnet wird; sonst bis Strg+C</translation>
    </message>
    <message>
        <source>wait for a bit (1.0/in.25, 1.0/in.25=0), a threshold in quotation marks (&quot;1.0/position&gt;1000&quot;, &quot;1.0/speed&lt;-50&quot;) or a message (fault, 1.0/attention)</source>
        <translation>auf ein Bit warten (1.0/in.25, 1.0/in.25=0), auf eine Schwelle in Anführungszeichen (&quot;1.0/position&gt;1000&quot;, &quot;1.0/speed&lt;-50&quot;) oder auf eine Meldung (fault, 1.0/attention)</translation>
    </message>
    <message>
        <source>also record what was before the trigger (0)</source>
        <translation>auch aufzeichnen, was vor dem Trigger war (0)</translation>
    </message>
    <message>
        <source>how long to record after the trigger; without: until Ctrl+C</source>
        <translation>wie lange nach dem Trigger aufgezeichnet wird; sonst bis Strg+C</translation>
    </message>
    <message>
        <source>keep the last hours only; what is older gives way</source>
        <translation>nur die letzten Stunden behalten; was älter ist, weicht</translation>
    </message>
    <message>
        <source>the largest size of the file; then what is oldest gives way</source>
        <translation>größter Umfang der Datei; danach weicht das Älteste</translation>
    </message>
    <message>
        <source>wait while the disk has less room for others (100)</source>
        <translation>warten, solange für andere weniger Platz auf der Platte frei ist (100)</translation>
    </message>
    <message>
        <source>only values and messages, without words and requests as they pass</source>
        <translation>nur Werte und Meldungen, ohne die Worte und Anfragen, wie sie vorbeikommen</translation>
    </message>
    <message>
        <source>It ended at %1.</source>
        <translation>Sie endete um %1.</translation>
    </message>
    <message>
        <source>It has not ended: it is still being written, or its program was killed. What came until %1 is there.</source>
        <translation>Sie hat kein Ende: Sie wird noch geschrieben, oder ihr Programm wurde abgebrochen. Was bis %1 kam, ist da.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Messages: %1. Notes: %2. Lost values: %3.</source>
        <translation>Meldungen: %1. Notizen: %2. Verlorene Werte: %3.</translation>
    </message>
    <message>
        <source>It is limited: what was before %1 is not there any more.</source>
        <translation>Sie ist begrenzt: Was vor %1 war, ist nicht mehr da.</translation>
    </message>
    <message>
        <source>%1: %2. No encoder has shown anything.</source>
        <translation>%1: %2. Kein Geber hat etwas gezeigt.</translation>
    </message>
    <message>
        <source>%1: %2, %3 from %4 to %5.</source>
        <translation>%1: %2, %3 von %4 bis %5.</translation>
    </message>
    <message>
        <source>The clock of the computer was set meanwhile, times: %1. The times of the samples pass evenly all the same.</source>
        <translation>Die Uhr des Rechners wurde währenddessen gestellt, Anzahl: %1. Die Zeiten der Werte vergehen trotzdem gleichmäßig.</translation>
    </message>
    <message>
        <source>the table to make, with a .json of the same name beside it that describes it</source>
        <translation>die Tabelle, die angelegt wird, mit einer gleichnamigen .json daneben, die sie beschreibt</translation>
    </message>
    <message>
        <source>its columns, with commas: 1.0/position,1.0/speed,1.0/in.25; without: everything</source>
        <translation>ihre Spalten, mit Kommas: 1.0/position,1.0/speed,1.0/in.25; sonst alles</translation>
    </message>
    <message>
        <source>from this time on: 2026-03-01T14:02:05, or +60, seconds from the beginning, or -60, before the end</source>
        <translation>ab dieser Zeit: 2026-03-01T14:02:05, oder +60, Sekunden ab dem Anfang, oder -60, vor dem Ende</translation>
    </message>
    <message>
        <source>up to this time</source>
        <translation>bis zu dieser Zeit</translation>
    </message>
    <message>
        <source>of positions and speeds: steps (the default), turns, degrees or millimetres</source>
        <translation>von Positionen und Geschwindigkeiten: steps (Schritte, sonst), turns, degrees oder millimetres</translation>
    </message>
    <message>
        <source>with millimetres: the way of one turn of a shaft</source>
        <translation>bei Millimetern: der Weg einer Umdrehung einer Welle</translation>
    </message>
    <message>
        <source>as the spreadsheets of the country want it</source>
        <translation>wie es die Tabellenprogramme des Landes wollen</translation>
    </message>
    <message>
        <source>replace CSV and its .json if they are there</source>
        <translation>CSV und ihre .json ersetzen, wenn es sie schon gibt</translation>
    </message>
    <message>
        <source>%1 is the recording itself. Nothing was saved. Name another file.</source>
        <translation>%1 ist die Aufzeichnung selbst. Nichts wurde gespeichert. Eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>The export was cancelled. Nothing was saved.</source>
        <translation>Der Export wurde abgebrochen. Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Written: %1 %</source>
        <translation>Geschrieben: %1 %</translation>
    </message>
    <message>
        <source>%1: %2 rows of %3 columns, from %4 to %5.</source>
        <translation>%1: %2 Zeilen mit %3 Spalten, von %4 bis %5.</translation>
    </message>
    <message>
        <source>What the table does not tell is in %1.</source>
        <translation>Was die Tabelle nicht sagt, steht in %1.</translation>
    </message>
    <message>
        <source>%1 has no values: no encoder has shown anything.</source>
        <translation>%1 hat keine Werte: Kein Geber hat etwas gezeigt.</translation>
    </message>
    <message>
        <source>tell what is in a recording, or make a table of it</source>
        <translation>sagen, was in einer Aufzeichnung steht, oder eine Tabelle daraus machen</translation>
    </message>
    <message>
        <source>Without -o: what was recorded when, of which encoders, how large it is, what was lost, and whether it
ended. With -o: all its values as a table of comma-separated values, and beside it a JSON file that tells
what the table cannot. pandas and PlotJuggler open the table as it is. The recording may still be written.

Needs no bus.</source>
        <translation>Ohne -o: was wann aufgezeichnet wurde, von welchen Gebern, wie groß die Aufzeichnung ist, was verloren ging
und ob sie ein Ende hat. Mit -o: alle Werte als Tabelle mit Kommas (CSV) und daneben eine JSON-Datei, die sagt,
was die Tabelle nicht sagen kann. pandas und PlotJuggler öffnen die Tabelle, wie sie ist. Die Aufzeichnung darf
noch geschrieben werden.

Braucht keinen Bus.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. Write it as 2026-03-01T14:02:05.250, as +60 (seconds from the beginning) or as -60 (before the end).</source>
        <translation>„%1“ ist keine Zeit. Als 2026-03-01T14:02:05.250 schreiben, als +60 (Sekunden ab dem Anfang) oder als -60 (vor dem Ende).</translation>
    </message>
    <message>
        <source>Nothing was recorded then. The recording is from %1 to %2.</source>
        <translation>Da wurde nichts aufgezeichnet. Die Aufzeichnung geht von %1 bis %2.</translation>
    </message>
    <message>
        <source>The recording has no &quot;%1&quot;. It has: %2. One bit is 1.0/in.25.</source>
        <translation>Die Aufzeichnung hat kein „%1“. Sie hat: %2. Ein einzelnes Bit ist 1.0/in.25.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no way per turn. Write millimetres with a point: 31.4.</source>
        <translation>„%1“ ist kein Weg je Umdrehung. Millimeter mit Punkt schreiben: 31.4.</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;. There are: %3.</source>
        <translation>%1 kann nicht „%2“ sein. Es gibt: %3.</translation>
    </message>
    <message>
        <source>How much of a millimetre a step of %1 is does not follow from the recording. For an encoder on a shaft --mm-per-turn tells it.</source>
        <translation>Wie viele Millimeter ein Schritt von %1 ist, geht aus der Aufzeichnung nicht hervor. Bei einem Geber an einer Welle sagt es --mm-per-turn.</translation>
    </message>
    <message>
        <source>How many steps a turn of %1 has does not follow from the recording. Leave --unit out, or name other tracks with --tracks.</source>
        <translation>Wie viele Schritte eine Umdrehung von %1 hat, geht aus der Aufzeichnung nicht hervor. --unit weglassen oder mit --tracks andere Werte angeben.</translation>
    </message>
    <message>
        <source>Give --for or --trigger, not both. How long to record after the trigger is told by --after.</source>
        <translation>--for oder --trigger angeben, nicht beides. Wie lange nach dem Trigger aufgezeichnet wird, sagt --after.</translation>
    </message>
    <message>
        <source>%1 counts from a trigger: give --trigger too. Without one, --for tells how long to record.</source>
        <translation>%1 zählt ab einem Trigger: auch --trigger angeben. Ohne Trigger sagt --for, wie lange aufgezeichnet wird.</translation>
    </message>
    <message>
        <source>--device tells what the encoder at a PLACE is. Name the PLACE.</source>
        <translation>--device sagt, was der Geber an einem PLACE ist. Den PLACE angeben.</translation>
    </message>
    <message>
        <source>The trigger has not come.</source>
        <translation>Der Auslöser hat nicht angesprochen.</translation>
    </message>
    <message>
        <source>No encoder has shown anything.</source>
        <translation>Kein Geber hat etwas gezeigt.</translation>
    </message>
    <message>
        <source>Nothing was recorded; the recording on %1 is empty.</source>
        <translation>Es wurde nichts aufgezeichnet; die Aufzeichnung auf %1 ist leer.</translation>
    </message>
    <message>
        <source>Nothing was recorded, and there is no file %1.</source>
        <translation>Es wurde nichts aufgezeichnet, und es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>Records into a file what the encoders show, every cycle and every answer, with messages, words and
requests: of the encoders at PLACE, or of all that are known. Writes nothing to any encoder; those on a
serial line are polled, as by monitor.

A real bus is recorded as time passes. The training bus has virtual time, and is recorded at once where it
is known how long. Whatever happens to the program, all up to the last second is in the file. It is made
anew: a recording is never written over. codewheel-cli export tells what is in it, and makes a table of it.

Several stations can record on one PostgreSQL server. While it is away what is recorded waits on this
computer, and follows.</source>
        <translation>Zeichnet in eine Datei auf, was die Geber zeigen, jeden Zyklus und jede Antwort, mit Meldungen, Worten und
Anfragen: von den Gebern an PLACE oder von allen bekannten. Schreibt in keinen Geber; die an einer
seriellen Leitung werden abgefragt wie mit monitor.

Ein echter Bus wird aufgezeichnet, während die Zeit vergeht. Der Übungsbus hat virtuelle Zeit; steht die
Dauer fest, ist die Aufzeichnung sofort fertig. Was dem Programm auch geschieht: Alles bis zur letzten
Sekunde steht in der Datei. Sie wird neu angelegt, eine Aufzeichnung nie überschrieben. codewheel-cli export
sagt, was in ihr steht, und macht eine Tabelle daraus.

Mehrere Stationen können auf einen PostgreSQL-Server aufzeichnen. Solange er nicht erreichbar ist, wartet das
Aufgezeichnete auf diesem Rechner und wird nachgereicht.</translation>
    </message>
    <message>
        <source>%1 wait for the server</source>
        <translation>%1 warten auf den Server</translation>
    </message>
    <message>
        <source>Give -o or --to, not both: a recording is in a file or on a server.</source>
        <translation>Entweder -o oder --to angeben: Eine Aufzeichnung steht in einer Datei oder auf einem Server.</translation>
    </message>
    <message>
        <source>Name the file of the recording: -o FILE, usually with a name that ends in .cwrec; or the server, --to ADDRESS.</source>
        <translation>Die Datei der Aufzeichnung nennen: -o FILE, gewöhnlich mit einem Namen auf .cwrec; oder den Server, --to ADDRESS.</translation>
    </message>
    <message>
        <source>record on a PostgreSQL server instead: postgresql://[USER@]HOST[:PORT]/DATABASE; passwords are in ~/.pgpass, PGPASSFILE or PGPASSWORD</source>
        <translation>stattdessen auf einen PostgreSQL-Server aufzeichnen: postgresql://[USER@]HOST[:PORT]/DATABASE; Passwörter stehen in ~/.pgpass, PGPASSFILE oder PGPASSWORD</translation>
    </message>
    <message>
        <source>on a server</source>
        <translation>auf einem Server</translation>
    </message>
    <message>
        <source>%1 is not for &quot;serve %2&quot;. Its options are: %3.</source>
        <translation>%1 gehört nicht zu „serve %2“. Die Optionen dort sind: %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be served. There is: %2.</source>
        <translation>„%1“ kann nicht angeboten werden. Es gibt: %2.</translation>
    </message>
    <message>
        <source>offer the simulated serial line or a simulated ring to other programs</source>
        <translation>die simulierte serielle Leitung oder einen simulierten Ring anderen Programmen anbieten</translation>
    </message>
    <message>
        <source>esc: prints the path of a pseudo terminal, which any program on this computer opens as a serial port, and
serves the encoders 03, 05 and 12 there, at the speed of a real line. Baud rates other than that of the
encoders give junk.

modbus-tcp, modbus-rtu: offers the process image of the training ring, or of the rings of --project that are
linked to it, as Modbus registers, as a gateway does; several clients at once over TCP. A write is
confirmed once it was on the bus. The ring runs in real time, in Operate.

Each serves until it is ended with Ctrl+C (SIGINT or SIGTERM).</source>
        <translation>esc: gibt den Pfad eines Pseudoterminals aus, das jedes Programm auf diesem Rechner als seriellen Anschluss
öffnet, und bietet dort die Geber 03, 05 und 12 mit der Geschwindigkeit einer echten Leitung an. Andere
Baudraten als die der Geber ergeben Datenmüll.

modbus-tcp, modbus-rtu: bietet das Prozessabbild des Übungsrings, oder der Ringe von --project, die mit ihm
verbunden sind, als Modbus-Register an, wie es ein Gateway tut; über TCP mehreren Clients zugleich. Ein
Schreiben wird bestätigt, sobald es auf dem Bus war. Der Ring läuft in Echtzeit und auf Bedienen.

Läuft, bis es mit Strg+C (SIGINT oder SIGTERM) beendet wird.</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1: keine</translation>
    </message>
    <message>
        <source>%1 from register %2: %3</source>
        <translation>%1 ab Register %2: %3</translation>
    </message>
    <message>
        <source>The bus &quot;%1&quot; is not behind a gateway. Name one, as --link modbus-tcp:192.168.0.5, or use --link project.</source>
        <translation>Der Bus „%1“ ist nicht hinter einem Gateway. Eines angeben, etwa --link modbus-tcp:192.168.0.5, oder --link project verwenden.</translation>
    </message>
    <message>
        <source>test a gateway step by step, and show the registers of its devices</source>
        <translation>ein Gateway Schritt für Schritt prüfen und die Register seiner Teilnehmer zeigen</translation>
    </message>
    <message>
        <source>Tests whether the gateway is there, its unit answers, and its registers are long enough for the ring of
the project. Then it reads the registers of each device, or of the one at PLACE, and shows the word in the
four orders that its bytes can have, and which of them the encoder can have sent. The one that is set
has a *. Writes nothing. Exit code 1 if anything failed.</source>
        <translation>Prüft, ob das Gateway da ist, seine Unit antwortet und seine Register für den Ring des Projekts reichen.
Dann liest es die Register jedes Teilnehmers, oder dessen auf PLACE, und zeigt das Wort in den vier
Reihenfolgen, die seine Bytes haben können, und welche davon der Geber gesendet haben kann. Die
eingestellte hat ein *. Schreibt nichts. Endet mit 1, wenn etwas fehlgeschlagen ist.</translation>
    </message>
    <message>
        <source>The gateway %1 cannot say which devices are in its ring. Name the project that does, with --project FILE.</source>
        <translation>Das Gateway %1 kann nicht sagen, welche Teilnehmer in seinem Ring sind. Das Projekt, das es sagt, mit --project FILE angeben.</translation>
    </message>
    <message>
        <source>The project does not say where the gateway of &quot;%1&quot; is. Enter it in the window, or name it, as --link modbus-tcp:192.168.0.5.</source>
        <translation>Das Projekt sagt nicht, wo das Gateway von „%1“ ist. Es im Fenster eintragen oder angeben, etwa --link modbus-tcp:192.168.0.5.</translation>
    </message>
    <message>
        <source>The project has several rings, and none of them is planned at %1. Give it to one of them in the project, and use --link project.</source>
        <translation>Das Projekt hat mehrere Ringe, und keiner davon ist an %1 geplant. Es im Projekt einem davon geben und --link project verwenden.</translation>
    </message>
    <message>
        <source>modbus-tcp:HOST[:PORT] and modbus-rtu:PORT, a gateway that shows the ring of the project as registers, as modbus-tcp:192.168.0.5,unit=1</source>
        <translation>modbus-tcp:HOST[:PORT] und modbus-rtu:PORT, ein Gateway, das den Ring des Projekts als Register zeigt, etwa modbus-tcp:192.168.0.5,unit=1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address in brackets with a port. Write it as [fe80::1] or [fe80::1]:502.</source>
        <translation>„%1“ ist keine Adresse in Klammern mit einem Port. So schreiben: [fe80::1] oder [fe80::1]:502.</translation>
    </message>
    <message>
        <source>Write the address %1 in brackets, as modbus-tcp:[%1], so that it can be told from a port.</source>
        <translation>Die Adresse %1 in Klammern schreiben, als modbus-tcp:[%1], damit sie sich von einem Port unterscheidet.</translation>
    </message>
    <message>
        <source>Name the host of the gateway, as --link modbus-tcp:192.168.0.5.</source>
        <translation>Den Host des Gateways angeben, etwa --link modbus-tcp:192.168.0.5.</translation>
    </message>
    <message>
        <source>Name the port behind &quot;%1&quot;, or leave the colon out for port 502.</source>
        <translation>Hinter „%1“ den Port angeben, oder für Port 502 den Doppelpunkt weglassen.</translation>
    </message>
    <message>
        <source>Name the port of the gateway, as --link modbus-rtu:ttyUSB0. %1</source>
        <translation>Den Anschluss des Gateways angeben, etwa --link modbus-rtu:ttyUSB0. %1</translation>
    </message>
    <message>
        <source>Exception %1: %2 (%3)</source>
        <translation>Exception %1: %2-mal (%3)</translation>
    </message>
    <message>
        <source>Transactions: %1. Exchanges: %2 (%3 a second). Retries: %4. Time-outs: %5. Wrong answers: %6. Connections: %7, of them lost: %8. Torn words: %9.</source>
        <translation>Transaktionen: %1. Austausche: %2 (%3 je Sekunde). Wiederholungen: %4. Zeitüberschreitungen: %5. Falsche Antworten: %6. Verbindungen: %7, davon verloren: %8. Zerrissene Worte: %9.</translation>
    </message>
    <message>
        <source>Status register: %1</source>
        <translation>Statusregister: %1</translation>
    </message>
    <message>
        <source>The project has no ring with devices whose link is the training bus.</source>
        <translation>Das Projekt hat keinen Ring mit Teilnehmern, dessen Verbindung der Übungsbus ist.</translation>
    </message>
    <message>
        <source>The project has %1 rings, each a unit of its own. Leave --seats out.</source>
        <translation>Das Projekt hat %1 Ringe, jeder eine eigene Unit. --seats weglassen.</translation>
    </message>
    <message>
        <source>A fault plan is for one ring. Name it with --fault-bus: %1.</source>
        <translation>Ein Fehlerplan gilt für einen Ring. Ihn mit --fault-bus angeben: %1.</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>IN, input</source>
        <translation>IN, Input</translation>
    </message>
    <message>
        <source>IN, holding</source>
        <translation>IN, Holding</translation>
    </message>
    <message>
        <source>OUT, holding</source>
        <translation>OUT, Holding</translation>
    </message>
    <message>
        <source>modbus-tcp: its number, 0 for a free one (1502); modbus-rtu: a serial port, with settings behind it, as ttyUSB0,baud=9600,unit=5 (a pseudo terminal)</source>
        <translation>modbus-tcp: seine Nummer, 0 für eine freie (1502); modbus-rtu: ein serieller Anschluss mit Einstellungen dahinter, etwa ttyUSB0,baud=9600,unit=5 (ein Pseudoterminal)</translation>
    </message>
    <message>
        <source>a ring of its own for each seat: unit 1 to N (one ring for all units)</source>
        <translation>für jeden Sitzplatz ein eigener Ring: Unit 1 bis N (ein Ring für alle Units)</translation>
    </message>
    <message>
        <source>clients may write nothing</source>
        <translation>Clients dürfen nichts schreiben</translation>
    </message>
    <message>
        <source>of this computer, where others reach it; 0.0.0.0: all it has (127.0.0.1, for programs on this computer only)</source>
        <translation>dieses Rechners, unter der ihn andere erreichen; 0.0.0.0: alle, die er hat (127.0.0.1, nur für Programme auf diesem Rechner)</translation>
    </message>
    <message>
        <source>Unit %1</source>
        <translation>Unit %1</translation>
    </message>
    <message>
        <source>Status register: %1. Diagnostic parameter: %2.</source>
        <translation>Statusregister: %1. Diagnoseparameter: %2.</translation>
    </message>
    <message>
        <source>Nothing can be written.</source>
        <translation>Es kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>All units</source>
        <translation>Alle Units</translation>
    </message>
    <message>
        <source>%1 requests, %2 of them refused; %3 writes</source>
        <translation>%1 Anfragen, davon %2 abgelehnt; %3 Schreibvorgänge</translation>
    </message>
    <message>
        <source>%1 is connected.</source>
        <translation>%1 ist verbunden.</translation>
    </message>
    <message>
        <source>%1 has left: %2.</source>
        <translation>%1 ist gegangen: %2.</translation>
    </message>
    <message>
        <source>%1 was refused: there are as many clients as can be served.</source>
        <translation>%1 wurde abgewiesen: Es sind schon so viele Clients da, wie bedient werden können.</translation>
    </message>
    <message>
        <source>Clients: %1, and %2 that were refused. %3.</source>
        <translation>Clients: %1, dazu %2 abgewiesene. %3.</translation>
    </message>
    <message>
        <source>Nothing was found that keeps a link from working.</source>
        <translation>Es wurde nichts gefunden, was eine Kopplung verhindert.</translation>
    </message>
    <message>
        <source>Something keeps a link from working: see above.</source>
        <translation>Etwas verhindert eine Kopplung: siehe oben.</translation>
    </message>
    <message>
        <source>what keeps a link from working, and what to do</source>
        <translation>was eine Kopplung verhindert, und was zu tun ist</translation>
    </message>
    <message>
        <source>Looks for what keeps ports and links from working: missing rights, a port that another program
has, an adapter without a driver or taken by brltty, ModemManager, a slow adapter, a CAN interface
that is switched off. With --link also for what is in the way of this link; a Modbus/TCP gateway
is connected and left again. To each it says what to do, with a command to copy. Opens no serial
port and sends nothing to an encoder. Ends with 1 if something prevents a link, else with 0.</source>
        <translation>Sucht, was Anschlüsse und Kopplungen verhindert: fehlende Rechte, ein Anschluss, den ein anderes
Programm hat, ein Adapter ohne Treiber oder von brltty belegt, ModemManager, ein langsamer Adapter,
eine ausgeschaltete CAN-Schnittstelle. Mit --link auch, was dieser Kopplung im Weg ist; ein
Modbus/TCP-Gateway wird kurz verbunden. Zu jedem steht, was zu tun ist, mit einem
Befehl zum Kopieren. Öffnet keinen seriellen Anschluss und sendet keinem Geber etwas. Endet mit 1,
wenn etwas eine Kopplung verhindert, sonst mit 0.</translation>
    </message>
    <message>
        <source>only listen: send nothing, connect nowhere</source>
        <translation>nur horchen: nichts senden, nirgends verbinden</translation>
    </message>
    <message>
        <source>ask silent lines and hosts without a question</source>
        <translation>stille Leitungen und Hosts ohne Rückfrage fragen</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>who</source>
        <translation>wer</translation>
    </message>
    <message>
        <source>To find out more, %1 would be asked. Only reads are sent:</source>
        <translation>Um mehr herauszufinden, würden gefragt: %1. Gesendet werden nur Leseanfragen:</translation>
    </message>
    <message>
        <source>Ask?</source>
        <translation>Fragen?</translation>
    </message>
    <message>
        <source>Nothing was sent. Add --yes to ask, or --listen to only listen.</source>
        <translation>Nichts wurde gesendet. Fügen Sie --yes an, um zu fragen, oder --listen, um nur zu horchen.</translation>
    </message>
    <message>
        <source>find encoders and gateways at ports and hosts</source>
        <translation>Geber und Gateways an Anschlüssen und Hosts finden</translation>
    </message>
    <message>
        <source>Looks for whoever is at these serial ports and hosts, or at every serial port of this computer. First
it listens: where somebody talks, a master is at work, and nothing is sent. Then it says what it would
send to lines that are silent, and to hosts, and asks whether it may. Only reads are sent. Each find is
told with how sure it is and the link that leads there. Ends with 1 if nobody was found.</source>
        <translation>Sucht, wer an diesen seriellen Anschlüssen und Hosts ist, oder an jedem seriellen Anschluss dieses
Rechners. Zuerst wird gehorcht: Wo jemand spricht, arbeitet ein Master, und nichts wird gesendet. Dann
wird gesagt, was an stille Leitungen und an Hosts gesendet würde, und gefragt, ob es darf. Nur Lesen
wird gesendet. Zu jedem Fund steht, wie sicher er ist, und die Kopplung, die dorthin führt. Endet mit
1, wenn niemand gefunden wurde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link. The search takes serial ports and hosts, such as ttyUSB0 or 192.168.0.5, and says which links lead there.</source>
        <translation>„%1“ ist eine Verbindung. Die Suche nimmt serielle Anschlüsse und Hosts, etwa ttyUSB0 oder 192.168.0.5, und sagt, welche Verbindungen dorthin führen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link. The search says which links lead to a place: type only %2.</source>
        <translation>„%1“ ist eine Verbindung. Welche Verbindungen zu einem Ort führen, sagt die Suche: Nur %2 eingeben.</translation>
    </message>
    <message>
        <source>--link cannot name %1, since there is a comma or a control character in it. Make a symbolic link without them, and name that.</source>
        <translation>--link kann %1 nicht nennen, da ein Komma oder ein Steuerzeichen darin ist. Legen Sie einen symbolischen Link ohne sie an, und nennen Sie diesen.</translation>
    </message>
    <message>
        <source>No encoder or gateway was found.</source>
        <translation>Kein Geber und kein Gateway gefunden.</translation>
    </message>
    <message>
        <source>In which state the encoder is, is not known until it is seen again.</source>
        <translation>In welchem Zustand der Geber ist, ist nicht bekannt, bis er wieder zu sehen ist.</translation>
    </message>
    <message>
        <source>how long an alarm-stop tries to get its zeros to a gateway (10)</source>
        <translation>wie lange ein alarm-stop versucht, seine Nullen an ein Gateway zu bringen (10)</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP have not arrived within %1 s. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs sind innerhalb von %1 s nicht angekommen. Halten Sie die Maschine mit ihren eigenen Mitteln an.</translation>
    </message>
    <message>
        <source>Connections that the gateway had closed while idle: %1. Stray bytes: %2. Echoes of our requests: %3.</source>
        <translation>Verbindungen, die das Gateway in Ruhe geschlossen hatte: %1. Verirrte Bytes: %2. Echos unserer Anfragen: %3.</translation>
    </message>
    <message>
        <source>Add to the link: %1</source>
        <translation>In den Link aufnehmen: %1</translation>
    </message>
    <message>
        <source>write the register that acknowledges the watchdog of the gateway, and nothing else</source>
        <translation>das Register schreiben, das den Watchdog des Gateways quittiert, und sonst nichts</translation>
    </message>
    <message>
        <source>%1 was written to register %2.</source>
        <translation>%1 wurde in Register %2 geschrieben.</translation>
    </message>
    <message>
        <source>Looks at the words of an encoder every 100 ms and prints a row when they differ from the last look.
Each row is printed as it comes. Sends nothing. The time is the bus&apos;s own: on the training bus a
cycle is 1 ms, and as it runs without waiting, the answer comes at once.

Of an encoder on a serial line (PLACE 05) it looks at position, alarms and warnings, which are polled, and
tells at the end how the line has done. Nothing is written. Ctrl+C ends it.</source>
        <translation>Sieht alle 100 ms nach den Worten eines Gebers und gibt eine Zeile aus, wenn sie sich seit dem letzten
Mal geändert haben, jede sofort. Sendet nichts. Die Zeit ist die des Busses: Am Übungsbus dauert ein Zyklus
1 ms, und da er läuft, ohne zu warten, kommt die Antwort sofort.

Bei einem Geber an einer seriellen Leitung (PLACE 05) werden Position, Alarme und Warnungen abgefragt;
am Ende steht, wie gut die Leitung war. Nichts wird geschrieben. Strg+C beendet es.</translation>
    </message>
    <message>
        <source>Written:</source>
        <translation>Geschrieben:</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>with a second column of dates and times of day, with their offset from UTC</source>
        <translation>mit einer zweiten Spalte für Datum und Uhrzeit samt Abstand zu UTC</translation>
    </message>
    <message>
        <source>Give --locale or --dates, not both: with --locale the first column has dates and times of day.</source>
        <translation>--locale oder --dates angeben, nicht beides: Mit --locale hat schon die erste Spalte Datum und Uhrzeit.</translation>
    </message>
    <message>
        <source>when</source>
        <translation>wann</translation>
    </message>
    <message>
        <source>at</source>
        <translation>an</translation>
    </message>
    <message>
        <source>computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood. The ledger is listed, by encoder or with entries one by one, or carried with export FILE, import FILE... and merge FOLDER.</source>
        <translation>„%1“ ist nicht zu verstehen. Das Verzeichnis wird aufgelistet, nach Gebern oder mit entries jeder Eintrag für sich, oder mit export DATEI, import DATEI... und merge ORDNER übertragen.</translation>
    </message>
    <message>
        <source>Lists for each encoder how often this program, window or command line, has written to its EEPROM, and
since when: by the serial number it told, else by the one typed from its label, else by its place in its
project. &quot;perhaps&quot; are writes that were begun, and the program ended before it saw them carried out.
&quot;entries&quot; lists them one by one, with computer and name of who wrote.
&quot;export&quot; saves all entries in a file, and &quot;import&quot; on another computer takes them into its ledger: the
same serial number is the same encoder there, and what was imported before is not counted twice. &quot;merge&quot;
does both with a folder that several computers share: it takes in what the others left there, and leaves
what is known here, in eeprom-writes-COMPUTER.json. Needs no bus.</source>
        <translation>Listet für jeden Geber auf, wie oft dieses Programm, Fenster oder Kommandozeile, in sein EEPROM
geschrieben hat und seit wann: nach der Seriennummer, die er gemeldet hat, sonst nach der vom
Typenschild abgetippten, sonst nach seinem Platz im Projekt. „vielleicht“ sind Schreibvorgänge, die
begonnen wurden und deren Ausführung das Programm vor seinem Ende nicht mehr sah.
„entries“ listet sie einzeln auf, mit Rechner und Namen dessen, der geschrieben hat.
„export“ speichert alle Einträge in einer Datei, und „import“ nimmt sie auf einem anderen Rechner in
dessen Verzeichnis auf: Dieselbe Seriennummer ist dort derselbe Geber, und was schon aufgenommen
wurde, zählt nicht doppelt. „merge“ tut beides mit einem Ordner, den mehrere Rechner teilen: Es nimmt
auf, was die anderen dort abgelegt haben, und legt in eeprom-writes-RECHNER.json ab, was hier bekannt
ist. Braucht keinen Bus.</translation>
    </message>
    <message>
        <source>Not taken in, and left as they are: %1</source>
        <translation>Nicht übernommen und unverändert gelassen: %1</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>Another program has locked its folder.</source>
        <translation>Ein anderes Programm hat seinen Ordner gesperrt.</translation>
    </message>
    <message>
        <source>Imported from %1 into %2: files: %3; new entries: %4; known already: %5.</source>
        <translation>Aus %1 in %2 importiert: Dateien: %3; neue Einträge: %4; schon bekannt: %5.</translation>
    </message>
    <message>
        <source>%1 is in parameterization and gives no position; what was read of it holds until run. %2</source>
        <translation>%1 ist in Parametrierung und liefert keine Position; was ausgelesen wurde, gilt bis Run. %2</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP have not arrived yet. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs sind noch nicht angekommen. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>Whether the ring runs behind the gateway is not known: the settings do not say which status bits tell it.</source>
        <translation>Ob der Ring hinter dem Gateway läuft, ist nicht bekannt: Die Einstellungen sagen nicht, welche Statusbits es melden.</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3. Ctrl+C cancels.</source>
        <translation>Schritt %1 von %2: %3. Strg+C bricht ab.</translation>
    </message>
    <message>
        <source>Cancelled: what is under way is ended first.</source>
        <translation>Abgebrochen: Was unterwegs ist, wird noch beendet.</translation>
    </message>
    <message>
        <source>switch the encoder to position mode afterwards, whatever mode it was in</source>
        <translation>den Geber danach in den Positionsbetrieb schalten, gleich in welcher Betriebsart er war</translation>
    </message>
    <message>
        <source>In which mode the encoder is now is not known.</source>
        <translation>In welcher Betriebsart der Geber jetzt ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The encoder is in %1 again, as before.</source>
        <translation>Der Geber ist wieder in der Betriebsart von vorher: %1.</translation>
    </message>
    <message>
        <source>The encoder is now in %1; before, it was in %2.</source>
        <translation>Betriebsart des Gebers jetzt: %1; vorher: %2.</translation>
    </message>
    <message>
        <source>The encoder is now in %1; in which mode it was before is not known.</source>
        <translation>Betriebsart des Gebers jetzt: %1; die vorherige ist nicht bekannt.</translation>
    </message>
    <message>
        <source>With --to-position it is in position mode afterwards.</source>
        <translation>Mit --to-position ist er danach im Positionsbetrieb.</translation>
    </message>
    <message>
        <source>--stay and --to-position contradict each other. Leave out one of them.</source>
        <translation>--stay und --to-position widersprechen sich. Eines davon weglassen.</translation>
    </message>
    <message>
        <source>read prints the cam programs, and saves them in FILE where one is named; a FILE that is there
already is replaced with --yes only. compare reads those that are in FILE and tells line by line
what differs; exit code 1 if anything does. write does the same, shows the words and the EEPROM
writes, asks, writes what differs, and reads it back. A FILE made for another device is refused.

Without --program, all eight are read, or all that are in the file. The encoder is in cam mode meanwhile.
Afterwards it is again in the mode it was in, where that is known; else, and with --stay, it stays in the
last of the programs, and with --to-position it is in position mode. In the end it is told in which
mode it is. A changed program is saved when it is left, with one EEPROM write.</source>
        <translation>read gibt die Nockenprogramme aus und speichert sie in FILE, wenn eine Datei genannt ist; eine vorhandene
wird nur mit --yes ersetzt. compare liest die Programme, die in FILE stehen, aus dem Geber und sagt Zeile
für Zeile, was abweicht; Rückgabewert 1, wenn etwas abweicht. write tut dasselbe, zeigt die Worte und
EEPROM-Schreibvorgänge, fragt, schreibt, was abweicht, und liest es zurück. Eine FILE für ein anderes Gerät
wird abgelehnt.

Ohne --program werden alle acht gelesen, oder alle aus der Datei. Der Geber ist solange im Nockenbetrieb.
Danach ist er wieder in der vorigen Betriebsart, wenn sie bekannt ist; sonst, und mit --stay, bleibt er
im letzten Programm, und mit --to-position ist er im Positionsbetrieb. Am Ende steht da, in welcher
Betriebsart er ist. Ein geändertes Programm wird beim Verlassen gespeichert: ein EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>The scaling factor is computed from them, and sent after them.</source>
        <translation>Der Skalierungsfaktor wird daraus berechnet und danach gesendet.</translation>
    </message>
    <message>
        <source>It is of another scale than the one of the project: with that, it is another position.</source>
        <translation>Sie hat eine andere Skalierung als die des Projekts: Damit ist sie eine andere Position.</translation>
    </message>
    <message>
        <source>How the encoder was scaled then is not known: it is right if its scale was the same.</source>
        <translation>Wie der Geber damals skaliert war, ist nicht bekannt: Sie stimmt, wenn seine Skalierung dieselbe war.</translation>
    </message>
    <message>
        <source>How the encoder was scaled then is not known in full: it is right if all of its scale was the same.</source>
        <translation>Wie der Geber damals skaliert war, ist nicht ganz bekannt: Sie stimmt, wenn seine ganze Skalierung dieselbe war.</translation>
    </message>
    <message>
        <source>%1, kept from before</source>
        <translation>%1, von früher behalten</translation>
    </message>
    <message>
        <source>confirmed; takes effect only with run</source>
        <translation>bestätigt; wird erst mit Run wirksam</translation>
    </message>
    <message>
        <source>The gateway closes the connection after each answer. Connections that ended so: %1.</source>
        <translation>Das Gateway schließt die Verbindung nach jeder Antwort. So beendete Verbindungen: %1.</translation>
    </message>
    <message>
        <source>Written and read back: cam program %1.</source>
        <translation>Geschrieben und zurückgelesen: Nockenprogramm %1.</translation>
    </message>
    <message>
        <source>Velocity mode: IN %1 shows no speed</source>
        <translation>Drehzahlbetrieb: IN %1 zeigt keine Drehzahl</translation>
    </message>
    <message>
        <source>The encoder is still in parameterization, as before: it shows no position.</source>
        <translation>Der Geber ist weiterhin in der Parametrierung, wie schon vorher: Er zeigt keine Position.</translation>
    </message>
    <message>
        <source>Reading has perhaps cost so many: %1.</source>
        <translation>So viele hat das Lesen vielleicht schon gekostet: %1.</translation>
    </message>
    <message>
        <source>Read the cam programs of %1?</source>
        <translation>Nockenprogramme von %1 lesen?</translation>
    </message>
    <message>
        <source>The reset itself, 0E000000, was not sent.</source>
        <translation>Das Zurücksetzen selbst, 0E000000, wurde nicht gesendet.</translation>
    </message>
    <message>
        <source>0E000000 and run were sent and answered; what the encoder has now was not read back.</source>
        <translation>0E000000 und Run wurden gesendet und beantwortet; was der Geber jetzt hat, wurde nicht zurückgelesen.</translation>
    </message>
    <message>
        <source>say that the encoder is in position mode: in cam mode the same word sets a cam</source>
        <translation>angeben, dass der Geber im Positionsbetrieb ist: im Nockenbetrieb setzt dasselbe Wort einen Nocken</translation>
    </message>
    <message>
        <source>sent, and refused by the encoder (error %1)</source>
        <translation>gesendet und vom Geber abgelehnt (Fehler %1)</translation>
    </message>
    <message>
        <source>sent, and not answered</source>
        <translation>gesendet und nicht beantwortet</translation>
    </message>
    <message>
        <source>%1 does not carry out %2 (exception 4). The watchdog of its outputs may have tripped: acknowledge it with codewheel-cli gateway --acknowledge-watchdog.</source>
        <translation>%1 führt %2 nicht aus (Exception 4). Der Watchdog seiner Ausgänge hat vielleicht angesprochen: mit codewheel-cli gateway --acknowledge-watchdog quittieren.</translation>
    </message>
    <message>
        <source>no registers</source>
        <translation>keine Register</translation>
    </message>
    <message>
        <source>registers %1 to %2</source>
        <translation>Register %1 bis %2</translation>
    </message>
    <message>
        <source>acknowledged at %1 ms (%2)</source>
        <translation>quittiert bei %1 ms (%2)</translation>
    </message>
    <message>
        <source>not acknowledged</source>
        <translation>nicht quittiert</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>read back as something else</source>
        <translation>anders zurückgelesen</translation>
    </message>
    <message>
        <source>not read back</source>
        <translation>nicht zurückgelesen</translation>
    </message>
    <message>
        <source>read back as 00000000 at %1 ms (%2)</source>
        <translation>als 00000000 zurückgelesen bei %1 ms (%2)</translation>
    </message>
    <message>
        <source>then as something else</source>
        <translation>danach anders</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were sent, but are not acknowledged yet: it is not known whether they have arrived. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden gesendet, sind aber noch nicht quittiert: Ob sie angekommen sind, ist nicht bekannt. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP are acknowledged, but not read back yet.</source>
        <translation>Die Nullen des ALARM-STOPPs sind quittiert, aber noch nicht zurückgelesen.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were sent, but not acknowledged within %1 s: it is not known whether they have arrived. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden gesendet, aber nicht innerhalb von %1 s quittiert: Ob sie angekommen sind, ist nicht bekannt. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP were acknowledged, but not read back within %1 s: it is not known whether they are still there. Stop the machine by its own means.</source>
        <translation>Die Nullen des ALARM-STOPPs wurden quittiert, aber nicht innerhalb von %1 s zurückgelesen: Ob sie noch dort stehen, ist nicht bekannt. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>sent at %1 ms (%2)</source>
        <translation>gesendet bei %1 ms (%2)</translation>
    </message>
    <message>
        <source>Zeros:          %1</source>
        <translation>Nullen:         %1</translation>
    </message>
    <message>
        <source>The cam programs are read in cam mode.</source>
        <translation>Die Nockenprogramme werden im Nockenbetrieb gelesen.</translation>
    </message>
    <message>
        <source>Nothing was sent: there is nobody to ask. Add --yes to read them.</source>
        <translation>Nichts gesendet: Es ist niemand da, der gefragt werden kann. Zum Lesen --yes angeben.</translation>
    </message>
    <message>
        <source>Where you are sure of it, add --in-position-mode.</source>
        <translation>Wo Sie sicher sind, --in-position-mode angeben.</translation>
    </message>
    <message>
        <source>EEPROM writes: none, it keeps no value without supply</source>
        <translation>EEPROM-Schreibvorgänge: keine, er behält ohne Versorgung keinen Wert</translation>
    </message>
    <message>
        <source>in force before, and stored now</source>
        <translation>galt schon vorher, jetzt gespeichert</translation>
    </message>
    <message>
        <source>Stored, in force before: %1.</source>
        <translation>Gespeichert, galten schon vorher: %1.</translation>
    </message>
</context>
<context>
    <name>codewheel::CommandList</name>
    <message>
        <source>reads: %1</source>
        <translation>liest: %1</translation>
    </message>
    <message>
        <source>writes: %1; %2 to %3, up to %4 hexadecimal digits</source>
        <translation>schreibt: %1; %2 bis %3, bis zu %4 Hexziffern</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
</context>
<context>
    <name>codewheel::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Words in any order, or their beginnings: of an action, a device, a parameter, a message or a page of the manual</source>
        <translation>Wörter in beliebiger Reihenfolge oder ihre Anfänge: von Aktionen, Geräten, Parametern, Meldungen oder Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>Return or a click carries it out</source>
        <translation>Eingabe oder ein Klick führt es aus</translation>
    </message>
    <message>
        <source>Command palette</source>
        <translation>Befehlspalette</translation>
    </message>
    <message>
        <source>Find a command, a device, a parameter, a message, a page of the manual</source>
        <translation>Befehl, Gerät, Parameter, Meldung oder Seite des Handbuchs suchen</translation>
    </message>
    <message>
        <source>Type what you are looking for.</source>
        <translation>Geben Sie ein, was Sie suchen.</translation>
    </message>
    <message>
        <source>Nothing is found for &quot;%1&quot;. Try fewer words, or the beginnings of words.</source>
        <translation>Für „%1“ wird nichts gefunden. Versuchen Sie es mit weniger Wörtern oder mit Wortanfängen.</translation>
    </message>
    <message>
        <source>What was used last, then what is used most</source>
        <translation>Zuletzt benutzt, dann die gebräuchlichsten</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n gefunden</numerusform>
            <numerusform>%n gefunden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::Comparison</name>
    <message>
        <source>device code %1, words: %2 IN, %3 OUT</source>
        <translation>Gerätecode %1, Worte: %2 IN, %3 OUT</translation>
    </message>
    <message>
        <source>%1: configured %2, found %3</source>
        <translation>%1: projektiert %2, gefunden %3</translation>
    </message>
    <message>
        <source>%1: %2, as configured</source>
        <translation>%1: %2, wie projektiert</translation>
    </message>
    <message>
        <source>%1: %2, as configured; its number is %3 now</source>
        <translation>%1: %2, wie projektiert; die Nummer ist jetzt %3</translation>
    </message>
    <message>
        <source>%1: %2 moved, configured on level %3, found on level %4</source>
        <translation>%1: %2 versetzt, projektiert auf Ebene %3, gefunden auf Ebene %4</translation>
    </message>
    <message>
        <source>%1: %2 moved, found at %3</source>
        <translation>%1: %2 versetzt, gefunden bei %3</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>additional</source>
        <translation>zusätzlich</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>versetzt</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>%1: %2 is additional: it is not configured</source>
        <translation>%1: %2 ist zusätzlich da und nicht projektiert</translation>
    </message>
    <message>
        <source>%1: configured %2 is missing</source>
        <translation>%1: %2 projektiert, fehlt</translation>
    </message>
    <message>
        <source>%1: %2 moved among its neighbours, its number stayed the same</source>
        <translation>%1: %2 unter seinen Nachbarn versetzt, die Nummer blieb gleich</translation>
    </message>
</context>
<context>
    <name>codewheel::ComparisonModel</name>
    <message>
        <source>Configured (project)</source>
        <translation>Projektiert (Projekt)</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Angeschlossen</translation>
    </message>
    <message>
        <source>%1, not up to date</source>
        <translation>%1, nicht aktuell</translation>
    </message>
</context>
<context>
    <name>codewheel::ComparisonPage</name>
    <message>
        <source>On&amp;ly differences</source>
        <translation>Nur &amp;Unterschiede</translation>
    </message>
    <message>
        <source>Chosen lines into the &amp;project</source>
        <translation>Gewählte Zeilen ins &amp;Projekt</translation>
    </message>
    <message>
        <source>&amp;All into the project</source>
        <translation>Alle &amp;ins Projekt</translation>
    </message>
    <message>
        <source>Connect to compare it with the project.</source>
        <translation>Verbinden, um ihn mit dem Projekt zu vergleichen.</translation>
    </message>
    <message>
        <source>Hides the lines that are the same</source>
        <translation>Blendet die gleichen Zeilen aus</translation>
    </message>
    <message>
        <source>Plans the chosen lines as they are connected; can be undone</source>
        <translation>Plant die gewählten Zeilen so, wie sie angeschlossen sind; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Choose the lines that are to be taken over.</source>
        <translation>Die Zeilen wählen, die übernommen werden sollen.</translation>
    </message>
    <message numerus="yes">
        <source>%n lines differ.</source>
        <translation>
            <numerusform>%n Zeile weicht ab.</numerusform>
            <numerusform>%n Zeilen weichen ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>Configured and connected bus</source>
        <translation>Projektierter und angeschlossener Bus</translation>
    </message>
    <message>
        <source>Plans the whole bus as it is connected; can be undone</source>
        <translation>Plant den ganzen Bus so, wie er angeschlossen ist; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Take over from the bus</source>
        <translation>Vom Bus übernehmen</translation>
    </message>
    <message>
        <source>What you take over changes the project alone. Nothing is sent here.</source>
        <translation>Was übernommen wird, ändert nur das Projekt. Hier wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Compare with the bus</source>
        <translation>Mit dem Bus vergleichen</translation>
    </message>
    <message>
        <source>The bus is as configured.</source>
        <translation>Der Bus ist wie projektiert.</translation>
    </message>
    <message>
        <source>The bus was as configured.</source>
        <translation>Der Bus war wie projektiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n lines differed.</source>
        <translation>
            <numerusform>%n Zeile wich ab.</numerusform>
            <numerusform>%n Zeilen wichen ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>The bus is not connected</source>
        <translation>Der Bus ist nicht verbunden</translation>
    </message>
    <message>
        <source>There is nothing to compare: this link does not tell which devices are on the ring. Those shown as connected are the ones that the project had when the ring was connected.</source>
        <translation>Es gibt nichts zu vergleichen: Diese Verbindung sagt nicht, welche Teilnehmer im Ring sind. Als angeschlossen gezeigt werden die, die das Projekt beim Verbinden hatte.</translation>
    </message>
</context>
<context>
    <name>codewheel::ConnectPage</name>
    <message>
        <source>Link</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>How this bus is reached</source>
        <translation>Wie dieser Bus erreicht wird</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Testen</translation>
    </message>
    <message>
        <source>&amp;Keep in project</source>
        <translation>Ins Pro&amp;jekt</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>&amp;Link</source>
        <translation>K&amp;opplung</translation>
    </message>
    <message>
        <source>Testing and connecting only read. Nothing is written to a device.</source>
        <translation>Testen und Verbinden lesen nur. In kein Gerät wird geschrieben.</translation>
    </message>
    <message>
        <source>Cancel &amp;test</source>
        <translation>&amp;Test abbrechen</translation>
    </message>
    <message>
        <source>Ends the test after its present step (Alt+T)</source>
        <translation>Beendet den Test nach dem laufenden Schritt (Alt+T)</translation>
    </message>
    <message>
        <source>Tries these settings step by step, and says what answers and what does not. Only reads (Alt+T)</source>
        <translation>Probiert diese Einstellungen Schritt für Schritt und sagt, was antwortet und was nicht. Liest nur (Alt+T)</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbindet…</translation>
    </message>
    <message>
        <source>Disconnects, and connects anew with these settings (Alt+C)</source>
        <translation>Trennt und verbindet neu mit diesen Einstellungen (Alt+V)</translation>
    </message>
    <message>
        <source>Keeps these settings in the project, and connects. Nothing is written (Alt+C)</source>
        <translation>Übernimmt diese Einstellungen ins Projekt und verbindet. Es wird nichts geschrieben (Alt+V)</translation>
    </message>
    <message>
        <source>The connection that is open is in the project</source>
        <translation>Die offene Verbindung steht im Projekt</translation>
    </message>
    <message>
        <source>Plans this connection in the project. Nothing is opened (Alt+K)</source>
        <translation>Plant diese Verbindung im Projekt. Es wird nichts geöffnet (Alt+J)</translation>
    </message>
    <message>
        <source>This connection is in the project.</source>
        <translation>Diese Verbindung steht im Projekt.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Disconnect first: a serial port has one user, and a gateway may have room for one client only</source>
        <translation>Zuerst trennen: Ein serieller Anschluss hat nur einen Benutzer, und ein Gateway hat vielleicht nur Platz für einen Client</translation>
    </message>
    <message>
        <source>Connected. Close this page (Esc) to see the encoders.</source>
        <translation>Verbunden. Diese Seite schließen (Esc), um die Geber zu sehen.</translation>
    </message>
    <message>
        <source>This bus is connected. It is disconnected first.</source>
        <translation>Dieser Bus ist verbunden. Er wird zuerst getrennt.</translation>
    </message>
    <message>
        <source>Disconnect and connect</source>
        <translation>Trennen und verbinden</translation>
    </message>
    <message>
        <source>This bus is connected to simulated encoders. It is disconnected first. What the project plans for them then counts for the real ones.</source>
        <translation>Dieser Bus ist mit simulierten Gebern verbunden. Er wird zuerst getrennt. Was das Projekt für sie plant, gilt dann für die echten.</translation>
    </message>
</context>
<context>
    <name>codewheel::CopyMenu</name>
    <message>
        <source>Copy &amp;as</source>
        <translation>Kopieren &amp;als</translation>
    </message>
    <message>
        <source>&amp;Hexadecimal: 020000FF</source>
        <translation>&amp;Hexadezimal: 020000FF</translation>
    </message>
    <message>
        <source>&amp;PLC: 16#0200_00FF</source>
        <translation>&amp;SPS: 16#0200_00FF</translation>
    </message>
    <message>
        <source>PLC, two &amp;words: 16#0200 16#00FF</source>
        <translation>SPS, zwei &amp;Worte: 16#0200 16#00FF</translation>
    </message>
    <message>
        <source>&amp;Decimal: 33554687</source>
        <translation>&amp;Dezimal: 33554687</translation>
    </message>
    <message>
        <source>Copy as &amp;two words of a PLC</source>
        <translation>Als &amp;zwei SPS-Worte kopieren</translation>
    </message>
    <message>
        <source>&amp;Binary: 2#0000_0010_…</source>
        <translation>&amp;Binär: 2#0000_0010_…</translation>
    </message>
</context>
<context>
    <name>codewheel::CurveBar</name>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>The unit of the chosen curve</source>
        <translation>Die Einheit der gewählten Kurve</translation>
    </message>
    <message>
        <source>Travel per turn</source>
        <translation>Weg je Umdrehung</translation>
    </message>
    <message>
        <source>How far the machine moves in one turn of this encoder; applies to all its curves</source>
        <translation>Wie weit sich die Maschine bei einer Umdrehung dieses Gebers bewegt; gilt für alle seine Kurven</translation>
    </message>
    <message>
        <source>On the a&amp;xis above</source>
        <translation>Auf der A&amp;chse darüber</translation>
    </message>
    <message>
        <source>Draws the chosen curve on the axis of the one above it, where both have one unit</source>
        <translation>Zeichnet die gewählte Kurve auf die Achse der Kurve darüber, wenn beide dieselbe Einheit haben</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Moves the chosen curve up (Alt+Up)</source>
        <translation>Schiebt die gewählte Kurve nach oben (Alt+Auf)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Moves the chosen curve down (Alt+Down)</source>
        <translation>Schiebt die gewählte Kurve nach unten (Alt+Ab)</translation>
    </message>
    <message>
        <source>Remove curve</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen curve; what is kept of it stays (Delete)</source>
        <translation>Entfernt die gewählte Kurve; was von ihr aufbewahrt ist, bleibt (Entf)</translation>
    </message>
    <message>
        <source> mm per turn</source>
        <translation> mm je Umdrehung</translation>
    </message>
    <message>
        <source>How many mm per turn?</source>
        <translation>Wie viele mm je Umdrehung?</translation>
    </message>
    <message>
        <source>How many steps this encoder has per turn is not known: read its parameters.</source>
        <translation>Wie viele Schritte dieser Geber je Umdrehung hat, ist nicht bekannt: Lesen Sie seine Parameter.</translation>
    </message>
    <message>
        <source>The measuring length, or the length of the rod, is not known: read or set them.</source>
        <translation>Die Messlänge oder die Stablänge ist nicht bekannt: lesen oder setzen.</translation>
    </message>
    <message>
        <source>A linear encoder has no turns.</source>
        <translation>Ein Lineargeber hat keine Umdrehungen.</translation>
    </message>
</context>
<context>
    <name>codewheel::CurveMenu</name>
    <message>
        <source>No encoder is connected</source>
        <translation>Kein Geber ist verbunden</translation>
    </message>
    <message>
        <source>Cams</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>Bits of %1</source>
        <comment>IN or OUT</comment>
        <translation>Bits von %1</translation>
    </message>
</context>
<context>
    <name>codewheel::DataCheck</name>
    <message>
        <source>Wait a moment. If nothing comes, check its supply and its place.</source>
        <translation>Kurz warten. Kommt nichts, Versorgung und Platz prüfen.</translation>
    </message>
    <message>
        <source>Wait for it, or end the search or the job.</source>
        <translation>Abwarten, oder die Suche oder den Auftrag beenden.</translation>
    </message>
    <message>
        <source>Wait for the next answer.</source>
        <translation>Die nächste Antwort abwarten.</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>operation</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>parameterization</source>
        <translation>Parametrierung</translation>
    </message>
    <message>
        <source>self test or read-out</source>
        <translation>Selbsttest oder Auslesen</translation>
    </message>
    <message>
        <source>service mode</source>
        <translation>Dienst</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>A job is at work on this encoder. Wait for its end, or cancel it.</source>
        <translation>An diesem Geber läuft ein Auftrag. Sein Ende abwarten, oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>The encoder tests itself, or shows a value that was asked for, not its position. Wait for the end of the self test; otherwise set OUT to 00000000, in its monitor.</source>
        <translation>Der Geber prüft sich selbst oder zeigt einen angefragten Wert, nicht seine Position. Das Ende des Selbsttests abwarten; sonst OUT in seinem Monitor auf 00000000 setzen.</translation>
    </message>
    <message>
        <source>The encoder answers a service and shows no position. Set OUT to 00000000, in its monitor, to bring it back.</source>
        <translation>Der Geber beantwortet einen Dienst und zeigt keine Position. OUT in seinem Monitor auf 00000000 setzen bringt ihn zurück.</translation>
    </message>
    <message>
        <source>The encoder reports an error. The messages say which.</source>
        <translation>Der Geber meldet einen Fehler. Welchen, steht in den Meldungen.</translation>
    </message>
    <message>
        <source>No manual says what this word means. Check which encoder is there, and in which order its bytes come.</source>
        <translation>Kein Handbuch sagt, was dieses Wort bedeutet. Prüfen, welcher Geber dort ist und in welcher Reihenfolge seine Bytes kommen.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>The bus is not connected. Connect it.</source>
        <translation>Der Bus ist nicht verbunden. Verbinden.</translation>
    </message>
    <message>
        <source>The program is connecting the bus. Wait for it.</source>
        <translation>Das Programm verbindet den Bus gerade. Abwarten.</translation>
    </message>
    <message>
        <source>Device</source>
        <comment>the kind of device at a place</comment>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>any: the project plans none here</source>
        <translation>beliebig: das Projekt plant hier keines</translation>
    </message>
    <message>
        <source>Last word or answer</source>
        <translation>Letztes Wort, letzte Antwort</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>the device has none</source>
        <translation>das Gerät hat keines</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>State of the encoder</source>
        <translation>Zustand des Gebers</translation>
    </message>
    <message>
        <source>not described</source>
        <translation>nicht beschrieben</translation>
    </message>
    <message>
        <source>This program has no description of this device: only its words are shown.</source>
        <translation>Dieses Programm hat keine Beschreibung dieses Geräts: nur seine Worte werden gezeigt.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>The position jumped further than the encoder can turn, and is being asked for again. If that happens often, check shield and termination of the line.</source>
        <translation>Die Position ist weiter gesprungen, als der Geber drehen kann, und wird noch einmal erfragt. Geschieht das oft, Schirm und Abschluss der Leitung prüfen.</translation>
    </message>
    <message>
        <source>cams: the encoder is in cam mode</source>
        <translation>Nocken: der Geber ist im Nockenmodus</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>as you want it</source>
        <translation>wie gewünscht</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>never to a recording</source>
        <translation>nie in eine Aufzeichnung</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Watch: values are read, and nothing can be written. Switch to Operate to write.</source>
        <translation>Beobachten: Werte werden gelesen, nichts kann geschrieben werden. Zum Schreiben auf Bedienen schalten.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>keine Störung</translation>
    </message>
    <message numerus="yes">
        <source>%n devices</source>
        <translation>
            <numerusform>%n Gerät</numerusform>
            <numerusform>%n Geräte</numerusform>
        </translation>
    </message>
    <message>
        <source>no position</source>
        <translation>keine Position</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>mindestens eines</translation>
    </message>
    <message>
        <source>No device is planned on this bus, so nothing is asked. Search for what is there, or enter it in the bus structure.</source>
        <translation>An diesem Bus ist kein Gerät geplant, deshalb wird nichts abgefragt. Suchen, was da ist, oder es im Busaufbau eintragen.</translation>
    </message>
    <message>
        <source>The encoder is in parameterization and shows what was written to it, not its position. Set OUT to 80000000 (run), in its monitor, until a position comes, then to 00000000.</source>
        <translation>Der Geber ist in der Parametrierung und zeigt, was ihm geschrieben wurde, nicht seine Position. Setzen Sie OUT in seinem Monitor auf 80000000 (Run), bis eine Position kommt, dann auf 00000000.</translation>
    </message>
    <message>
        <source>The make of the encoder is not known, and so neither is the coding of its position. Name it in the bus structure.</source>
        <translation>Der Hersteller des Gebers ist nicht bekannt und damit auch nicht die Codierung seiner Position. Geben Sie ihn im Busaufbau an.</translation>
    </message>
    <message>
        <source>IN may be a position, a speed or cams: the mode of the encoder is not known, and cannot be read. If it is in position mode, say so (Parameters, More).</source>
        <translation>IN kann eine Position, eine Geschwindigkeit oder Nocken sein: Die Betriebsart des Gebers ist nicht bekannt und nicht auslesbar. Ist er im Positionsbetrieb, geben Sie das an (Parameter, Mehr).</translation>
    </message>
    <message>
        <source>The coding of the position in IN is not known. Read the parameters, write the coding, or set it manually under Parameters.</source>
        <translation>Wie die Position in IN codiert ist, ist nicht bekannt. Lesen Sie die Parameter, schreiben Sie die Codierung, oder setzen Sie sie unter Parameter von Hand.</translation>
    </message>
    <message>
        <source>a speed: %1 rpm</source>
        <translation>eine Geschwindigkeit: %1 U/min</translation>
    </message>
    <message>
        <source>%1, the same since %2</source>
        <comment>20 s ago, 14:02</comment>
        <translation>%1, dasselbe seit %2</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
</context>
<context>
    <name>codewheel::DataCheckModel</name>
    <message>
        <source>as expected</source>
        <translation>wie erwartet</translation>
    </message>
    <message>
        <source>worth knowing</source>
        <translation>gut zu wissen</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Tatsächlich</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
</context>
<context>
    <name>codewheel::DecimalText</name>
    <message>
        <source>&quot;%1&quot; may mean %2 or %3. Leave the sign between thousands out, or write the decimals with &quot;%4&quot;.</source>
        <translation>„%1“ kann %2 oder %3 bedeuten. Ohne Tausendertrennzeichen eingeben oder die Nachkommastellen mit „%4“ schreiben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has point and comma. Write it without signs between thousands.</source>
        <translation>„%1“ enthält Punkt und Komma. Ohne Tausendertrennzeichen eingeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number. Digits only, for example 1000.</source>
        <translation>„%1“ ist keine ganze Zahl. Nur Ziffern, zum Beispiel 1000.</translation>
    </message>
</context>
<context>
    <name>codewheel::DescriptionReader</name>
    <message>
        <source>A key consists of the letters a to z, digits and hyphens.</source>
        <translation>Ein Schlüssel besteht aus den Buchstaben a bis z, Ziffern und Bindestrichen.</translation>
    </message>
    <message>
        <source>The minimum is larger than the maximum.</source>
        <translation>Das Minimum ist größer als das Maximum.</translation>
    </message>
    <message>
        <source>The factory setting is not between minimum and maximum.</source>
        <translation>Die Werkseinstellung liegt nicht zwischen Minimum und Maximum.</translation>
    </message>
    <message>
        <source>The factory setting is none of the choices.</source>
        <translation>Die Werkseinstellung ist nicht unter den Auswahlwerten.</translation>
    </message>
    <message>
        <source>The budget is larger than eepromLimit.</source>
        <translation>Das Budget ist größer als eepromLimit.</translation>
    </message>
    <message>
        <source>Only a K1 and a K2 always have the same coding. Leave it out.</source>
        <translation>Nur ein K1 und ein K2 haben immer dieselbe Codierung. Weglassen.</translation>
    </message>
    <message>
        <source>There is no device with the key &quot;%1&quot; before this one.</source>
        <translation>Vor diesem gibt es kein Gerät mit dem Schlüssel „%1“.</translation>
    </message>
    <message>
        <source>What only the label tells can be neither written nor read.</source>
        <translation>Was nur auf dem Typenschild steht, lässt sich weder schreiben noch lesen.</translation>
    </message>
    <message>
        <source>A parameter needs a number to write it, a readOut code to read it, both, or onLabel; on a serial line the commands read or write.</source>
        <translation>Ein Parameter braucht number zum Schreiben, einen readOut-Code zum Lesen, beides oder onLabel; an einer seriellen Leitung die Befehle read oder write.</translation>
    </message>
    <message>
        <source>This value is here twice.</source>
        <translation>Dieser Wert steht hier doppelt.</translation>
    </message>
    <message>
        <source>This key is here twice.</source>
        <translation>Dieser Schlüssel steht hier doppelt.</translation>
    </message>
    <message>
        <source>This parameter is here twice.</source>
        <translation>Dieser Parameter steht hier doppelt.</translation>
    </message>
    <message>
        <source>This number is here twice.</source>
        <translation>Diese Nummer steht hier doppelt.</translation>
    </message>
    <message>
        <source>A parameter is named by small letters, digits, hyphens, colons and full stops.</source>
        <translation>Ein Parameter wird mit Kleinbuchstaben, Ziffern, Bindestrichen, Doppelpunkten und Punkten benannt.</translation>
    </message>
    <message>
        <source>An encoder of the profile %1 has only numbers. Leave it out.</source>
        <translation>Ein Geber des Profils %1 hat nur Zahlen. Weglassen.</translation>
    </message>
</context>
<context>
    <name>codewheel::DescriptionRules</name>
    <message>
        <source>The ID code of the profile %1 is %2.</source>
        <translation>Der ID-Code des Profils %1 ist %2.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>The device code of the profile %1 is %2.</source>
        <translation>Der Gerätecode des Profils %1 ist %2.</translation>
    </message>
    <message>
        <source>A value that is written must be between 0 and %1: the word has no room for others.</source>
        <translation>Ein Wert, der geschrieben wird, muss zwischen 0 und %1 liegen: Für andere ist im Wort kein Platz.</translation>
    </message>
    <message>
        <source>An encoder of the profile %1 has no parameters that this program could write or read. Leave it out.</source>
        <translation>Ein Geber mit dem Profil %1 hat keine Parameter, die dieses Programm schreiben oder lesen könnte. Weglassen.</translation>
    </message>
    <message>
        <source>An encoder of the profile %1 cannot do this. Write false.</source>
        <translation>Ein Geber mit dem Profil %1 kann das nicht. false schreiben.</translation>
    </message>
    <message>
        <source>Only with the dialect fraba are the words for it known. Write false.</source>
        <translation>Nur mit dem Dialekt fraba sind die Worte dafür bekannt. false schreiben.</translation>
    </message>
    <message>
        <source>Parameter number %1 sets all values to default. It cannot be the number of a parameter, too.</source>
        <translation>Parameternummer %1 setzt alle Werte auf Werkseinstellung. Sie kann nicht zugleich die Nummer eines Parameters sein.</translation>
    </message>
    <message>
        <source>An encoder on a serial line has the commands read and write. Leave it out.</source>
        <translation>Ein Geber an einer seriellen Leitung hat die Befehle read und write. Weglassen.</translation>
    </message>
    <message>
        <source>What is written must be read, too: a write without an answer is checked.</source>
        <translation>Was geschrieben wird, muss sich auch lesen lassen: Ein Schreiben ohne Antwort wird nachgeprüft.</translation>
    </message>
    <message>
        <source>Only an encoder on a serial line has commands. Leave it out.</source>
        <translation>Nur ein Geber an einer seriellen Leitung hat Befehle. Weglassen.</translation>
    </message>
    <message>
        <source>The words of the profile %1 are: IN %2, OUT %3.</source>
        <translation>Die Worte des Profils %1 sind: IN %2, OUT %3.</translation>
    </message>
    <message>
        <source>The word that sets the position takes the parameter preset. Give preset a number, or write false.</source>
        <translation>Das Wort, das die Position setzt, enthält den Parameter preset. Für preset eine number angeben oder false schreiben.</translation>
    </message>
    <message>
        <source>The parameter preset tells the range of the position, and is read after it was set. Give preset the command read, or write false.</source>
        <translation>Der Parameter preset nennt den Bereich der Position und wird nach dem Setzen gelesen. Für preset den Befehl read angeben oder false schreiben.</translation>
    </message>
    <message>
        <source>The encoder gets the position together with the command that sets it. Write true.</source>
        <translation>Der Geber bekommt die Position zusammen mit dem Befehl, der sie setzt. true schreiben.</translation>
    </message>
    <message>
        <source>The preset is read, and programmed again. Give preset a number and a readOut, or write false.</source>
        <translation>Der Preset wird gelesen und neu programmiert. Für preset eine number und ein readOut angeben oder false schreiben.</translation>
    </message>
    <message>
        <source>The parameter multi-turn-steps-minus-1 tells which of both the encoder does. Give it a readOut, or write false.</source>
        <translation>Der Parameter multi-turn-steps-minus-1 sagt, welches von beidem für den Geber gilt. Dafür ein readOut angeben oder false schreiben.</translation>
    </message>
    <message>
        <source>An encoder that is sent steps - 1 cannot be sent 0 steps. Let the minimum of steps be 1 or more.</source>
        <translation>Einem Geber, der Schritte - 1 erwartet, lassen sich nicht 0 Schritte geben. Als minimum von steps 1 oder mehr angeben.</translation>
    </message>
    <message>
        <source>Cams and velocity are modes beside position mode, in which words mean something else. Write true.</source>
        <translation>Nocken und Drehzahl sind Betriebsarten neben dem Positionsbetrieb, in denen Worte etwas anderes bedeuten. true schreiben.</translation>
    </message>
    <message>
        <source>Only with the dialect fraba are the words of a read-out known. Leave it out.</source>
        <translation>Nur beim Dialekt fraba sind die Worte zum Auslesen bekannt. Weglassen.</translation>
    </message>
    <message>
        <source>%1 has %2 here. Anything else makes the encoder do or show something else.</source>
        <translation>%1 hat hier den Wert %2. Mit einem anderen würde der Geber etwas anderes tun oder melden.</translation>
    </message>
    <message>
        <source>%1 has nothing here. Leave it out: the encoder would do or show something else.</source>
        <translation>%1 hat hier keinen Wert. Weglassen: Der Geber würde sonst etwas anderes tun oder melden.</translation>
    </message>
    <message>
        <source>%1 of the profile %2</source>
        <comment>a parameter, as subject of a sentence</comment>
        <translation>%1 des Profils %2</translation>
    </message>
    <message>
        <source>What is written must be read, too: it is read back.</source>
        <translation>Was geschrieben wird, muss auch gelesen werden: Es wird zurückgelesen.</translation>
    </message>
    <message>
        <source>A baud rate is 19200, 9600 or 4800.</source>
        <translation>Als Baudrate gibt es 19200, 9600 und 4800.</translation>
    </message>
    <message>
        <source>A value that is written must be between %1 and %2.</source>
        <translation>Ein Wert, der geschrieben wird, muss zwischen %1 und %2 liegen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a command that writes a value.</source>
        <translation>„%1“ ist kein Befehl, der einen Wert schreibt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a command that reads a value.</source>
        <translation>„%1“ ist kein Befehl, der einen Wert liest.</translation>
    </message>
    <message>
        <source>A K3 has words for %1 cams in each program. Write %1.</source>
        <translation>Ein K3 hat Worte für %1 Nocken in jedem Programm. %1 schreiben.</translation>
    </message>
    <message>
        <source>A K3 shows its cams in a mode of their own. Write true.</source>
        <translation>Ein K3 zeigt seine Nocken in einer eigenen Betriebsart. true schreiben.</translation>
    </message>
    <message>
        <source>A K3 shows its cams beside a part of the position. Write true.</source>
        <translation>Ein K3 zeigt seine Nocken neben einem Teil der Position. true schreiben.</translation>
    </message>
    <message>
        <source>A K3 has no word for the hysteresis of a cam. Write false.</source>
        <translation>Ein K3 hat kein Wort für die Hysterese eines Nockens. false schreiben.</translation>
    </message>
    <message>
        <source>A K3 has no word for the polarity of a cam. Write false.</source>
        <translation>Ein K3 hat kein Wort für die Polarität eines Nockens. false schreiben.</translation>
    </message>
    <message>
        <source>Only a K3 has a dialect. Leave it out.</source>
        <translation>Nur ein K3 hat einen Dialekt. Weglassen.</translation>
    </message>
    <message>
        <source>An encoder on a serial line has none. Leave it out.</source>
        <translation>Ein Geber an einer seriellen Leitung hat das nicht. Weglassen.</translation>
    </message>
    <message>
        <source>Only a description of the generic dialect has no vendor.</source>
        <translation>Nur eine Beschreibung mit dem Dialekt generic hat keinen Hersteller.</translation>
    </message>
    <message>
        <source>The last two digits must be those of idCode.</source>
        <translation>Die letzten zwei Ziffern müssen die von idCode sein.</translation>
    </message>
    <message>
        <source>A bit is one of the answer to a command read, and there is none.</source>
        <translation>Ein Bit gehört zur Antwort auf einen Befehl read; hier gibt es keinen.</translation>
    </message>
    <message>
        <source>This command is here twice.</source>
        <translation>Dieser Befehl steht hier doppelt.</translation>
    </message>
    <message>
        <source>This number is here twice.</source>
        <translation>Diese Nummer steht hier doppelt.</translation>
    </message>
    <message>
        <source>This readOut code is here twice.</source>
        <translation>Dieser readOut-Code steht hier doppelt.</translation>
    </message>
</context>
<context>
    <name>codewheel::DesktopNotice</name>
    <message>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
</context>
<context>
    <name>codewheel::DeviceHtml</name>
    <message>
        <source>Manual: %1</source>
        <comment>chapter</comment>
        <translation>Handbuch: %1</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Device code</source>
        <translation>Gerätecode</translation>
    </message>
    <message>
        <source>Words IN / OUT</source>
        <translation>Worte IN / OUT</translation>
    </message>
    <message>
        <source>Steps per turn</source>
        <translation>Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source>%1 (manual: %2)</source>
        <translation>%1 (Handbuch: %2)</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Notes and assumptions</source>
        <translation>Anmerkungen und Annahmen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>LEDs</source>
        <translation>LEDs</translation>
    </message>
    <message>
        <source>LED</source>
        <translation>LED</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>%1 blinking</source>
        <translation>%1 blinkt</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Key on the label, e.g. %1</source>
        <translation>Schlüssel auf dem Typenschild, z. B. %1</translation>
    </message>
    <message>
        <source>any, may be missing</source>
        <translation>beliebig, kann fehlen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>codewheel::DeviceNames</name>
    <message>
        <source>Name %1</source>
        <translation>%1 benennen</translation>
    </message>
</context>
<context>
    <name>codewheel::DevicePage</name>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Which en&amp;coder is to be set up?</source>
        <translation>Welcher Geber s&amp;oll eingerichtet werden?</translation>
    </message>
    <message>
        <source>Encoders of the bus</source>
        <translation>Geber am Bus</translation>
    </message>
    <message>
        <source>The encoders of the bus. Nothing is sent by choosing one.</source>
        <translation>Die Geber am Bus. Das Wählen sendet nichts.</translation>
    </message>
    <message>
        <source>There is no encoder on the bus. Start the bus first: Bus &gt; Start.</source>
        <translation>Am Bus ist kein Geber. Erst den Bus starten: Bus &gt; Starten.</translation>
    </message>
    <message>
        <source>Choose one with the arrow keys or the mouse.</source>
        <translation>Einen mit den Pfeiltasten oder der Maus wählen.</translation>
    </message>
    <message>
        <source>Description: %1</source>
        <translation>Beschreibung: %1</translation>
    </message>
    <message>
        <source>The make of this encoder is not known. If you know it, name it in the bus structure: then direction and errors are shown by name.</source>
        <translation>Der Hersteller dieses Gebers ist unbekannt. Im Busaufbau lässt er sich angeben: Dann werden Zählrichtung und Fehler beim Namen genannt.</translation>
    </message>
</context>
<context>
    <name>codewheel::DevicePanel</name>
    <message>
        <source>No description</source>
        <translation>Keine Beschreibung</translation>
    </message>
    <message>
        <source>What the manual says of the device</source>
        <translation>Was das Handbuch über das Gerät sagt</translation>
    </message>
    <message>
        <source>Pins, LEDs, limits, label key and parameters, with the chapter of the manual</source>
        <translation>Anschlüsse, LEDs, Grenzwerte, Typenschlüssel und Parameter, mit dem Kapitel des Handbuchs</translation>
    </message>
    <message>
        <source>Put one into the folder codewheel/devices of your data folder, or type the key on its label to look one up.</source>
        <translation>Eine in den Ordner codewheel/devices des eigenen Datenordners legen, oder ein Gerät mit dem Schlüssel vom Typenschild nachschlagen.</translation>
    </message>
    <message>
        <source>Choose one in the bus structure, or type the key on a label to look one up.</source>
        <translation>Eines im Busaufbau wählen, oder ein Gerät mit dem Schlüssel vom Typenschild nachschlagen.</translation>
    </message>
    <message>
        <source>It connects the devices behind it to the ring; there is nothing to describe.</source>
        <translation>Sie verbindet die Geräte dahinter mit dem Ring; zu beschreiben gibt es nichts.</translation>
    </message>
    <message>
        <source>There is no description of %1</source>
        <translation>Für %1 gibt es keine Beschreibung</translation>
    </message>
    <message>
        <source>No device is chosen</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
    <message>
        <source>%1 is a bus terminal</source>
        <translation>%1 ist eine Busklemme</translation>
    </message>
</context>
<context>
    <name>codewheel::DialHead</name>
    <message>
        <source>Pin dial</source>
        <translation>Anzeige anheften</translation>
    </message>
    <message>
        <source>Pinned</source>
        <comment>the dial</comment>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>Let the dial follow the bus structure again</source>
        <translation>Die Anzeige wieder dem Busaufbau folgen lassen</translation>
    </message>
    <message>
        <source>Keep this dial when another encoder is chosen</source>
        <translation>Diese Anzeige behalten, wenn ein anderer Geber gewählt wird</translation>
    </message>
</context>
<context>
    <name>codewheel::DialPanel</name>
    <message>
        <source>Choose one in the bus structure.</source>
        <translation>Einen im Busaufbau wählen.</translation>
    </message>
    <message>
        <source>Its position is shown once its bus is connected.</source>
        <translation>Die Position wird angezeigt, sobald der Bus verbunden ist.</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>The dial is pinned to this place. Unpinned, it follows the bus structure.</source>
        <translation>Die Anzeige ist an diesen Platz geheftet. Gelöst folgt sie dem Busaufbau.</translation>
    </message>
    <message>
        <source>No encoder is chosen</source>
        <translation>Kein Geber gewählt</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 ist nicht verbunden</translation>
    </message>
    <message>
        <source>There is no encoder at %1</source>
        <comment>2.0</comment>
        <translation>Auf Platz %1 ist kein Geber</translation>
    </message>
    <message>
        <source>Show &amp;position in trend</source>
        <translation>&amp;Position im Trend zeigen</translation>
    </message>
    <message>
        <source>Show &amp;speed in trend</source>
        <translation>&amp;Drehzahl im Trend zeigen</translation>
    </message>
    <message>
        <source>The project plans it, but it is not on the bus that is connected. Its position is shown once it is.</source>
        <translation>Das Projekt plant ihn, aber am verbundenen Bus ist er nicht. Die Position wird angezeigt, sobald er da ist.</translation>
    </message>
</context>
<context>
    <name>codewheel::DirectionPage</name>
    <message>
        <source>Direction</source>
        <translation>Zählrichtung</translation>
    </message>
    <message>
        <source>Check &amp;again</source>
        <translation>Neu &amp;prüfen</translation>
    </message>
    <message>
        <source>Count as it does no&amp;w</source>
        <translation>Zählen wie &amp;jetzt</translation>
    </message>
    <message>
        <source>Count the &amp;other way round</source>
        <translation>A&amp;ndersherum zählen</translation>
    </message>
    <message>
        <source>Turn the shaft a little, the way the machine moves forward. Nothing is sent.</source>
        <translation>Die Welle ein wenig so drehen, wie die Maschine vorwärts fährt. Nichts wird gesendet.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>The direction of the encoder is kept.</source>
        <translation>Die Zählrichtung des Gebers bleibt.</translation>
    </message>
    <message>
        <source>The direction the encoder has now is not known: read it, or choose it on the page of the values.</source>
        <translation>Die jetzige Zählrichtung des Gebers ist unbekannt: auslesen oder auf der Seite mit den Werten wählen.</translation>
    </message>
    <message>
        <source>The encoder shows no position now (IN %1). Bring it back to operation first.</source>
        <translation>Der Geber zeigt jetzt keine Position (IN %1). Den Geber erst wieder in Betrieb bringen.</translation>
    </message>
    <message>
        <source>The position is not known, since mode or coding of the encoder is not. The raw word is watched instead; trust it only for slow, small moves.</source>
        <translation>Die Position ist nicht bestimmbar: Betriebsart oder Codierung des Gebers ist unbekannt. Beobachtet wird das Rohwort; verlässlich ist das nur bei langsamen, kleinen Bewegungen.</translation>
    </message>
    <message>
        <source>%1 steps so far</source>
        <translation>bisher %1 Schritte</translation>
    </message>
    <message>
        <source>Does not move yet</source>
        <translation>Steht noch still</translation>
    </message>
    <message>
        <source>Counts up</source>
        <translation>Zählt aufwärts</translation>
    </message>
    <message>
        <source>Counts down</source>
        <translation>Zählt abwärts</translation>
    </message>
    <message>
        <source>Move the magnet a little, the way the machine moves forward. Nothing is sent.</source>
        <translation>Den Magneten ein Stück bewegen, so wie die Maschine vorwärts fährt. Gesendet wird nichts.</translation>
    </message>
    <message>
        <source>Goes both ways: move it one way only</source>
        <translation>Geht hin und her: nur in eine Richtung bewegen</translation>
    </message>
    <message>
        <source>Not up to date</source>
        <translation>Nicht aktuell</translation>
    </message>
    <message>
        <source>Forget the movements seen so far.</source>
        <translation>Die bisherigen Bewegungen vergessen.</translation>
    </message>
    <message>
        <source>The other direction is added to the wanted values.</source>
        <translation>Die andere Zählrichtung kommt zu den gewünschten Werten.</translation>
    </message>
    <message>
        <source>When moved this way, the position should:</source>
        <translation>Bei dieser Bewegung soll die Position:</translation>
    </message>
</context>
<context>
    <name>codewheel::DisabledKey</name>
    <message>
        <source>Not possible now: %1. %2</source>
        <comment>action, why or what it does</comment>
        <translation>Jetzt nicht möglich: %1. %2</translation>
    </message>
</context>
<context>
    <name>codewheel::DisplayMenu</name>
    <message>
        <source>Bits in &amp;rows of 8</source>
        <translation>Bits in &amp;8er-Reihen</translation>
    </message>
    <message>
        <source>Bar over the &amp;position range</source>
        <translation>Balken über dem &amp;Positionsbereich</translation>
    </message>
    <message>
        <source>&amp;Decimal</source>
        <translation>&amp;Dezimal</translation>
    </message>
    <message>
        <source>&amp;Signed</source>
        <translation>Mit &amp;Vorzeichen</translation>
    </message>
    <message>
        <source>&amp;Gray</source>
        <translation>&amp;Gray</translation>
    </message>
    <message>
        <source>&amp;Binary</source>
        <translation>&amp;Binär</translation>
    </message>
    <message>
        <source>Numbers of the &amp;whole word, not of D24..D0</source>
        <translation>Zahlen für das ga&amp;nze Wort, nicht für D24..D0</translation>
    </message>
</context>
<context>
    <name>codewheel::Doctor</name>
    <message>
        <source>The CAN interface %1 is switched off. Switch it on with the bit rate of the bus.</source>
        <translation>Die CAN-Schnittstelle %1 ist ausgeschaltet. Schalten Sie sie mit der Bitrate des Busses ein.</translation>
    </message>
    <message>
        <source>%1 is in use by another bus of this program. Disconnect that one.</source>
        <translation>%1 wird von einem anderen Bus dieses Programms benutzt. Trennen Sie dessen Verbindung.</translation>
    </message>
    <message>
        <source>%1 is in use by the program %2 (process %3). Close it there, or end it.</source>
        <translation>%1 wird vom Programm %2 (Prozess %3) benutzt. Schließen Sie den Anschluss dort, oder beenden Sie das Programm.</translation>
    </message>
    <message>
        <source>The adapter of %1 collects bytes for up to %2 ms, which slows down every answer, until a program asks for low latency as Codewheel does.</source>
        <translation>Der Adapter von %1 sammelt Bytes bis zu %2 ms lang, was jede Antwort verzögert, bis ein Programm kurze Latenz verlangt, wie Codewheel es tut.</translation>
    </message>
    <message>
        <source>You may not use %1 yet: you are in its group %2 from your next login on. Log out and in again. In a terminal, this is enough.</source>
        <translation>Sie dürfen %1 noch nicht benutzen: Sie sind erst ab der nächsten Anmeldung in seiner Gruppe %2. Melden Sie sich ab und wieder an. In einem Terminal genügt dies.</translation>
    </message>
    <message>
        <source>You may not use %1: you are not in its group %2. Join it, then log out and in again.</source>
        <translation>Sie dürfen %1 nicht benutzen: Sie sind nicht in seiner Gruppe %2. Treten Sie ihr bei, dann melden Sie sich ab und wieder an.</translation>
    </message>
    <message>
        <source>There is no port %1. Plug its adapter in, and see whether the system names it.</source>
        <translation>Es gibt keinen Anschluss %1. Stecken Sie seinen Adapter ein, und sehen Sie nach, ob das System ihn nennt.</translation>
    </message>
    <message>
        <source>The adapter %1 has no port: brltty takes it for a Braille display. Unless you use one, switch that off and plug the adapter in again.</source>
        <translation>Der Adapter %1 hat keinen Anschluss: brltty hält ihn für eine Braillezeile. Wenn Sie keine benutzen, schalten Sie das ab und stecken Sie den Adapter neu ein.</translation>
    </message>
    <message>
        <source>The adapter %1 (%2) is plugged in, but no driver has made a port of it. Load its driver.</source>
        <translation>Der Adapter %1 (%2) steckt, aber kein Treiber hat einen Anschluss daraus gemacht. Laden Sie seinen Treiber.</translation>
    </message>
    <message>
        <source>ModemManager runs: for some seconds after an adapter is plugged in, it sends to it to find a modem, and nobody else can use the port. Stop it if you need no modem.</source>
        <translation>ModemManager läuft: Nach dem Einstecken eines Adapters sendet er ihm einige Sekunden lang, um ein Modem zu finden, und niemand sonst kann den Anschluss benutzen. Halten Sie ihn an, wenn Sie kein Modem brauchen.</translation>
    </message>
    <message>
        <source>A server at port %1 needs rights on this computer that you do not have. Use a port from %2 on, or allow it until the next start of the computer.</source>
        <translation>Ein Server am Port %1 braucht auf diesem Rechner Rechte, die Sie nicht haben. Nehmen Sie einen Port ab %2, oder erlauben Sie es bis zum nächsten Start des Rechners.</translation>
    </message>
    <message>
        <source>The system offers a login at %1 (%2, process %3). Switch that off if nobody logs in there.</source>
        <translation>Das System bietet an %1 eine Anmeldung an (%2, Prozess %3). Schalten Sie das ab, wenn sich dort niemand anmeldet.</translation>
    </message>
    <message>
        <source>The file %2 keeps %1 for a program that has ended. Remove it.</source>
        <translation>Die Datei %2 hält %1 für ein Programm frei, das beendet ist. Entfernen Sie sie.</translation>
    </message>
    <message>
        <source>You may not use %1. Its group %2 may, but that is no group for serial ports: do not join it. Let yourself use the port until it is unplugged or the computer starts again.</source>
        <translation>Sie dürfen %1 nicht benutzen. Seine Gruppe %2 darf es, ist aber keine für serielle Anschlüsse: Treten Sie ihr nicht bei. Geben Sie sich selbst das Zugriffsrecht, bis der Anschluss abgezogen wird oder der Rechner neu startet.</translation>
    </message>
    <message>
        <source>You may not use %1, and no group of users may. Let yourself use it until it is unplugged or the computer starts again.</source>
        <translation>Sie dürfen %1 nicht benutzen, und keine Benutzergruppe darf es. Geben Sie sich selbst das Zugriffsrecht, bis der Anschluss abgezogen wird oder der Rechner neu startet.</translation>
    </message>
</context>
<context>
    <name>codewheel::DroppedDevice</name>
    <message>
        <source>%1 is not a device description that can be used. %2: %3</source>
        <translation>%1 ist keine brauchbare Gerätebeschreibung. %2: %3</translation>
    </message>
    <message>
        <source>%1 is a device description. Replace yours of the same name with it?</source>
        <translation>%1 ist eine Gerätebeschreibung. Soll sie die eigene mit demselben Namen ersetzen?</translation>
    </message>
    <message>
        <source>%1 is a device description. Keep it with your own?</source>
        <translation>%1 ist eine Gerätebeschreibung. Soll sie bei den eigenen aufgehoben werden?</translation>
    </message>
    <message>
        <source>&amp;Keep it</source>
        <translation>Auf&amp;heben</translation>
    </message>
    <message>
        <source>%1 could not be kept: %2</source>
        <translation>%1 wurde nicht aufgehoben: %2</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>%1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>%1 is kept. Its device is in the catalog from the next start on.</source>
        <translation>%1 ist aufgehoben. Das Gerät steht ab dem nächsten Start im Katalog.</translation>
    </message>
</context>
<context>
    <name>codewheel::DroppedFiles</name>
    <message numerus="yes">
        <source>%n files were dropped. Drop one at a time.</source>
        <translation>
            <numerusform>%n Datei wurde abgelegt. Nur eine auf einmal ablegen.</numerusform>
            <numerusform>%n Dateien wurden abgelegt. Nur eine auf einmal ablegen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 cannot be read.</source>
        <translation>%1 lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>%1 is a Codewheel file, but not one that can be opened by dropping it. Projects, cams, sequences, fault plans, device descriptions and recordings can.</source>
        <translation>%1 ist eine Datei von Codewheel, lässt sich aber nicht durch Ablegen öffnen. Das geht mit Projekten, Nocken, Sequenzen, Fehlerplänen, Gerätebeschreibungen und Aufzeichnungen.</translation>
    </message>
    <message>
        <source>%1 cannot be dropped here. Projects, cams, sequences, fault plans, device descriptions and recordings can.</source>
        <translation>%1 kann hier nicht abgelegt werden. Das geht mit Projekten, Nocken, Sequenzen, Fehlerplänen, Gerätebeschreibungen und Aufzeichnungen.</translation>
    </message>
</context>
<context>
    <name>codewheel::DurationField</name>
    <message>
        <source>Unit: %1</source>
        <translation>Einheit: %1</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
</context>
<context>
    <name>codewheel::Eeprom</name>
    <message>
        <source>counted by the serial number %1 read from the encoder</source>
        <translation>gezählt nach der Seriennummer %1, die der Geber gemeldet hat</translation>
    </message>
    <message>
        <source>counted by the serial number %1 on its label</source>
        <translation>gezählt nach der Seriennummer %1 auf dem Typenschild</translation>
    </message>
    <message>
        <source>counted by its place, since the serial number is not known</source>
        <translation>gezählt nach dem Platz, da die Seriennummer nicht bekannt ist</translation>
    </message>
    <message>
        <source>counted since the connection was made</source>
        <translation>gezählt, seit die Verbindung besteht</translation>
    </message>
    <message>
        <source>EEPROM writes by this program since %1: %2</source>
        <translation>EEPROM-Schreibvorgänge durch dieses Programm seit %1: %2</translation>
    </message>
    <message>
        <source>EEPROM writes by this program so far: %1</source>
        <translation>EEPROM-Schreibvorgänge durch dieses Programm bisher: %1</translation>
    </message>
    <message>
        <source>%1 writes by Codewheel</source>
        <translation>%1-mal von Codewheel geschrieben</translation>
    </message>
    <message>
        <source>This program has written %1 times to the EEPROM; the manual states about %2 writes. Write only what has to be written.</source>
        <translation>Dieses Programm hat %1-mal in das EEPROM geschrieben; das Handbuch spricht von etwa %2. Nur das Nötige schreiben.</translation>
    </message>
    <message>
        <source>With %1 writes by this program and %2 more, the %3 or so that the manual states are used up. The encoder may lose its values.</source>
        <translation>Mit %1 Schreibvorgängen durch dieses Programm und %2 weiteren sind die etwa %3 verbraucht, von denen das Handbuch spricht. Der Geber kann seine Werte verlieren.</translation>
    </message>
    <message>
        <source>With %1 writes by this program and %2 more, the EEPROM is beyond the %3 that the manual guarantees at most. The encoder may lose its values at any time: replace it soon.</source>
        <translation>Mit %1 Schreibvorgängen durch dieses Programm und %2 weiteren ist das EEPROM über die %3 hinaus, die das Handbuch höchstens zusichert. Der Geber kann seine Werte jederzeit verlieren: bald ersetzen.</translation>
    </message>
    <message>
        <source>1 write by Codewheel</source>
        <translation>1-mal von Codewheel geschrieben</translation>
    </message>
    <message>
        <source>%1, perhaps %2 more</source>
        <translation>%1, vielleicht %2 mehr</translation>
    </message>
    <message>
        <source>(and perhaps %1 more, which it began and did not see the end of)</source>
        <translation>(und vielleicht %1 weitere, die es begonnen und deren Ende es nicht gesehen hat)</translation>
    </message>
    <message>
        <source>(and perhaps %1 more, counted by its place before its serial number was known)</source>
        <translation>(und vielleicht noch %1, nach seinem Platz gezählt, bevor seine Seriennummer bekannt war)</translation>
    </message>
    <message>
        <source>since %1</source>
        <comment>writes since a date</comment>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>(and perhaps %1 more, counted by its place for the encoder that was there before)</source>
        <translation>(und vielleicht noch %1, nach seinem Platz gezählt, für den Geber, der vorher dort war)</translation>
    </message>
</context>
<context>
    <name>codewheel::EepromGate</name>
    <message>
        <source>Write &amp;nevertheless</source>
        <translation>&amp;Trotzdem schreiben</translation>
    </message>
    <message>
        <source>The EEPROM has been written as often as the manual states</source>
        <translation>Das EEPROM wurde so oft beschrieben, wie das Handbuch angibt</translation>
    </message>
    <message>
        <source>Place, to write nevertheless</source>
        <translation>Platz, um trotzdem zu schreiben</translation>
    </message>
    <message>
        <source>The place of the encoder, so that nothing is written beyond the limit by accident</source>
        <translation>Der Platz des Gebers, damit über die Grenze hinaus nichts aus Versehen geschrieben wird</translation>
    </message>
    <message>
        <source>Type %1 to write nevertheless</source>
        <translation>%1 eintippen, um trotzdem zu schreiben</translation>
    </message>
    <message>
        <source>Write to the EEPROM of %1?</source>
        <translation>In das EEPROM von %1 schreiben?</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>Other encoders as well: %1.</source>
        <translation>Auch andere Geber: %1.</translation>
    </message>
    <message>
        <source>Starts what you asked for</source>
        <translation>Beginnt mit dem, was verlangt wurde</translation>
    </message>
</context>
<context>
    <name>codewheel::EncoderChoice</name>
    <message>
        <source>&amp;All encoders</source>
        <translation>&amp;Alle Geber</translation>
    </message>
    <message>
        <source>Of all buses, and those that are connected later</source>
        <translation>An allen Bussen, auch die, die später verbunden werden</translation>
    </message>
    <message>
        <source>&amp;Only these:</source>
        <translation>Nur &amp;diese:</translation>
    </message>
    <message>
        <source>Only the encoders that are ticked below</source>
        <translation>Nur die Geber, die unten angekreuzt sind</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Encoders that are ticked are recorded (Space)</source>
        <translation>Angekreuzte Geber werden aufgezeichnet (Leertaste)</translation>
    </message>
</context>
<context>
    <name>codewheel::EncoderFaults</name>
    <message>
        <source>IN is 0</source>
        <translation>IN ist 0</translation>
    </message>
    <message>
        <source>slow</source>
        <comment>to confirm</comment>
        <translation>langsam</translation>
    </message>
    <message>
        <source>invalid</source>
        <comment>position</comment>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>no magnet</source>
        <translation>kein Magnet</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>%1 takes long to confirm OUT %2, or does not know the word. Wait; if nothing comes, check which encoder it is, and switch it off and on.</source>
        <translation>%1 braucht lange, um OUT %2 zu quittieren, oder kennt das Wort nicht. Warten; kommt nichts, prüfen, welcher Geber es ist, und ihn aus- und einschalten.</translation>
    </message>
    <message>
        <source>IN of %1 fell to 00000000: the encoder has no supply, or is at position 0. Check its supply, or turn the shaft to see it change.</source>
        <translation>IN von %1 fiel auf 00000000: Der Geber hat keine Versorgung oder steht auf Position 0. Versorgung prüfen, oder die Welle drehen und sehen, ob sich IN ändert.</translation>
    </message>
    <message>
        <source>doubtful</source>
        <comment>IN word</comment>
        <translation>fraglich</translation>
    </message>
    <message>
        <source>parameters</source>
        <comment>parameterization</comment>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>%1 was left in parameterization and gives no position.</source>
        <translation>%1 blieb in der Parametrierung und gibt keine Position aus.</translation>
    </message>
    <message>
        <source>%1 was left in %2: the controller gets no position.</source>
        <comment>an encoder, a mode</comment>
        <translation>%1 blieb im %2: Die Steuerung bekommt keine Position.</translation>
    </message>
    <message>
        <source>mode?</source>
        <comment>it is not known</comment>
        <translation>Betriebsart?</translation>
    </message>
    <message>
        <source>It is not known in which mode %1 was left: the controller may get no position.</source>
        <translation>Es ist nicht bekannt, in welcher Betriebsart %1 blieb: Die Steuerung bekommt vielleicht keine Position.</translation>
    </message>
</context>
<context>
    <name>codewheel::EncoderFunctions</name>
    <message>
        <source>P&amp;osition mode</source>
        <translation>P&amp;ositionsbetrieb</translation>
    </message>
    <message>
        <source>The encoder sends its position; ends velocity and cam mode</source>
        <translation>Der Geber sendet seine Position; beendet Drehzahl- und Nockenbetrieb</translation>
    </message>
    <message>
        <source>The encoder sends its speed in revolutions per minute instead of its position</source>
        <translation>Der Geber sendet seine Drehzahl in Umdrehungen pro Minute statt seiner Position</translation>
    </message>
    <message>
        <source>Sets the position to the programmed preset, as often as wanted; asks first</source>
        <translation>Setzt die Position auf den programmierten Preset, beliebig oft; fragt vorher</translation>
    </message>
    <message>
        <source>Shows what is lost, and asks first</source>
        <translation>Sagt, was verloren geht, und fragt vorher</translation>
    </message>
    <message>
        <source>&amp;Velocity mode (now: %1)</source>
        <translation>&amp;Drehzahlbetrieb (jetzt: %1)</translation>
    </message>
    <message>
        <source>All cam programs are lost, too, and the encoder is in position mode afterwards.</source>
        <translation>Auch alle Nockenprogramme gehen verloren; danach ist der Geber im Positionsbetrieb.</translation>
    </message>
    <message>
        <source>In which mode is the encoder %1?</source>
        <translation>In welcher Betriebsart ist der Geber %1?</translation>
    </message>
    <message>
        <source>It can also be put into position mode first: 20800000, then 20400000. Where it is in a cam program that was changed, that stores the program: one EEPROM write.</source>
        <translation>Er kann auch zuerst in den Positionsbetrieb geschaltet werden: 20800000, dann 20400000. Ist er in einem geänderten Nockenprogramm, wird dieses dabei gespeichert: ein EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>It is in &amp;position mode</source>
        <translation>Er ist im &amp;Positionsbetrieb</translation>
    </message>
    <message>
        <source>Put it into position &amp;mode</source>
        <translation>In den Positions&amp;betrieb schalten</translation>
    </message>
    <message>
        <source>Sends 20800000 and 20400000, then goes on</source>
        <translation>Sendet 20800000 und 20400000, dann geht es weiter</translation>
    </message>
    <message>
        <source>Leave cam mode at %1?</source>
        <translation>Den Nockenbetrieb bei %1 verlassen?</translation>
    </message>
    <message>
        <source>The cams switch no more. A cam program that was changed is stored when it is left: one EEPROM write.</source>
        <translation>Die Nocken schalten nicht mehr. Ein geändertes Nockenprogramm wird beim Verlassen gespeichert: ein EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>&amp;Leave cam mode</source>
        <translation>Nockenbetrieb &amp;verlassen</translation>
    </message>
    <message>
        <source>Sends 20800000, then goes on</source>
        <translation>Sendet 20800000, dann geht es weiter</translation>
    </message>
    <message>
        <source>not known: read it, or write one, under Parameters</source>
        <translation>unbekannt: unter Parameter auslesen oder schreiben</translation>
    </message>
    <message>
        <source>Set the position of %1 to its preset?</source>
        <translation>Die Position von %1 auf den Preset setzen?</translation>
    </message>
    <message>
        <source>&amp;Set position</source>
        <translation>Position &amp;setzen</translation>
    </message>
    <message>
        <source>Sends 60000000 for one bus cycle, then 00000000</source>
        <translation>Sendet einen Buszyklus lang 60000000, dann 00000000</translation>
    </message>
    <message>
        <source>Afterwards the encoder is read, to see what it has then.</source>
        <translation>Danach wird der Geber ausgelesen, um seinen Stand zu kennen.</translation>
    </message>
    <message>
        <source>Reset %1 to factory settings?</source>
        <translation>%1 auf Werkseinstellungen zurücksetzen?</translation>
    </message>
    <message>
        <source>Sends 0E000000, then run. %1</source>
        <translation>Sendet 0E000000, dann Run. %1</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>It &amp;is in position mode</source>
        <translation>Er &amp;ist im Positionsbetrieb</translation>
    </message>
    <message>
        <source>FRABA &amp;preset…</source>
        <translation>FRABA-&amp;Preset…</translation>
    </message>
    <message>
        <source>Reset to &amp;factory settings…</source>
        <translation>Auf &amp;Werkseinstellungen zurücksetzen…</translation>
    </message>
    <message>
        <source>This is lost: %1.</source>
        <translation>Verloren gehen: %1.</translation>
    </message>
    <message>
        <source>Continues, since you have made sure</source>
        <translation>Geht weiter, weil das sicher ist</translation>
    </message>
    <message>
        <source>It cannot be read: afterwards it is assumed to have the factory settings of its manual.</source>
        <translation>Er lässt sich nicht auslesen: Danach gelten die Werkseinstellungen laut Handbuch.</translation>
    </message>
    <message>
        <source>Sends 0E000000, then run. This cannot be undone.</source>
        <translation>Sendet 0E000000, dann Run. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Only if you are sure: in cam mode, the word that sets the position sets a cam. Nothing is sent.</source>
        <translation>Nur angeben, wenn es sicher ist: Im Nockenbetrieb setzt das Wort, das die Position setzt, einen Nocken. Es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>FRABA preset: where the shaft stands now, the encoder will show its preset (%1). 60000000 is sent for one bus cycle. It can be repeated, at one EEPROM write each time.</source>
        <translation>FRABA-Preset: Wo die Welle jetzt steht, zeigt der Geber danach seinen Preset (%1). 60000000 wird einen Buszyklus lang gesendet. Das lässt sich wiederholen und kostet jedes Mal einen EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>set the position, zero, zero point</source>
        <translation>Position setzen, nullen, Nullpunkt</translation>
    </message>
    <message>
        <source>Send run to %1?</source>
        <translation>Run an %1 senden?</translation>
    </message>
    <message>
        <source>&amp;Send run</source>
        <translation>Run &amp;senden</translation>
    </message>
    <message>
        <source>Sends 80000000, then 00000000</source>
        <translation>Sendet 80000000, dann 00000000</translation>
    </message>
    <message>
        <source>Restore the earlier values of %1?</source>
        <translation>Die vorigen Werte von %1 wiederherstellen?</translation>
    </message>
    <message>
        <source>Run is sent first, and until the earlier values are written the encoder gives its position by what it has taken. Then these are written: %1.</source>
        <translation>Zuerst wird Run gesendet; bis die vorigen Werte geschrieben sind, zeigt der Geber seine Position nach dem, was er angenommen hat. Dann werden geschrieben: %1.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Sends run, then writes the earlier values, then sends run again</source>
        <translation>Sendet Run, schreibt dann die vorigen Werte und sendet noch einmal Run</translation>
    </message>
    <message>
        <source>Writes the earlier values, then sends run</source>
        <translation>Schreibt die früheren Werte und sendet dann Run</translation>
    </message>
    <message>
        <source>Written before run is sent, so that nothing it has taken so far becomes valid: %1.</source>
        <translation>Geschrieben, bevor Run gesendet wird, damit nichts gilt, was der Geber bisher angenommen hat: %1.</translation>
    </message>
    <message>
        <source>not known</source>
        <comment>mode</comment>
        <translation>unbekannt</translation>
    </message>
</context>
<context>
    <name>codewheel::EscEncoderBox</name>
    <message>
        <source>Raw position</source>
        <translation>Rohposition</translation>
    </message>
    <message>
        <source>Supply of the encoder; it keeps what was written</source>
        <translation>Versorgung des Gebers; was geschrieben wurde, bleibt erhalten</translation>
    </message>
    <message>
        <source>It receives and acts, but does not answer</source>
        <translation>Er empfängt und handelt, antwortet aber nicht</translation>
    </message>
    <message>
        <source>Warning: soon to be changed</source>
        <translation>Warnung: bald tauschen</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Alarm: temperature exceeded</source>
        <translation>Alarm: Temperatur überschritten</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>The input makes the values fall</source>
        <translation>Der Eingang lässt die Werte fallen</translation>
    </message>
    <message>
        <source>RS-422: without +UB at ST no command works</source>
        <translation>RS-422: Ohne +UB an ST wirkt kein Befehl</translation>
    </message>
    <message>
        <source>Speed in revolutions per minute</source>
        <translation>Drehzahl in Umdrehungen pro Minute</translation>
    </message>
    <message>
        <source>Revolutions per minute; positive is clockwise, looking at the shaft</source>
        <translation>Umdrehungen pro Minute; positiv ist rechtsherum, mit Blick auf die Welle</translation>
    </message>
    <message>
        <source>Stop the shaft</source>
        <translation>Welle anhalten</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Drehzahl, U/min</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineActions</name>
    <message>
        <source>Serial &amp;line</source>
        <translation>Serielle &amp;Leitung</translation>
    </message>
    <message>
        <source>Asks one address after the other; nothing is written</source>
        <translation>Fragt eine Adresse nach der anderen; nichts wird geschrieben</translation>
    </message>
    <message>
        <source>&amp;Terminal</source>
        <translation>&amp;Terminal</translation>
    </message>
    <message>
        <source>Line st&amp;atistics</source>
        <translation>Stat&amp;istik der Leitung</translation>
    </message>
    <message>
        <source>Port, state, answers and time-outs of the line</source>
        <translation>Anschluss, Zustand, Antworten und Zeitüberschreitungen der Leitung</translation>
    </message>
    <message>
        <source>T&amp;raining line</source>
        <translation>Ü&amp;bungsleitung</translation>
    </message>
    <message>
        <source>Three simulated encoders, in place of a port</source>
        <translation>Drei simulierte Geber anstelle eines Anschlusses</translation>
    </message>
    <message>
        <source>&amp;Disconnect the line</source>
        <translation>Leitung t&amp;rennen</translation>
    </message>
    <message>
        <source>Closes the serial line</source>
        <translation>Schließt die serielle Leitung</translation>
    </message>
    <message>
        <source>&amp;Swap warning bytes</source>
        <translation>Warnungs&amp;bytes tauschen</translation>
    </message>
    <message>
        <source>Remove from the serial &amp;line</source>
        <translation>Aus der seriellen &amp;Leitung nehmen</translation>
    </message>
    <message>
        <source>For encoders on the serial line</source>
        <translation>Für Geber an der seriellen Leitung</translation>
    </message>
    <message>
        <source>For an encoder that sends the low byte of its warnings first; nothing is sent</source>
        <translation>Für einen Geber, der das niederwertige Byte seiner Warnungen zuerst sendet; gesendet wird nichts</translation>
    </message>
    <message>
        <source>The encoder is not asked any more; what it has stays as it is</source>
        <translation>Der Geber wird nicht mehr abgefragt; sein Stand bleibt unverändert</translation>
    </message>
    <message>
        <source>&amp;Search for encoders…</source>
        <translation>Geber &amp;suchen…</translation>
    </message>
    <message>
        <source>Shows the traffic on the line, and sends what you type</source>
        <translation>Zeigt, was über die Leitung geht, und sendet Eingetipptes</translation>
    </message>
    <message>
        <source>&amp;Connection…</source>
        <translation>&amp;Verbindung…</translation>
    </message>
    <message>
        <source>How the line is connected: port and settings. Nothing is written</source>
        <translation>Wie die Leitung verbunden wird: Anschluss und Einstellungen. Es wird nichts geschrieben</translation>
    </message>
    <message>
        <source>serial port, adapter, baud rate</source>
        <translation>serieller Anschluss, Adapter, Baudrate</translation>
    </message>
    <message>
        <source>Start a&amp;fresh</source>
        <translation>Neu b&amp;eginnen</translation>
    </message>
    <message>
        <source>reset, factory settings, no faults</source>
        <translation>zurücksetzen, Werkseinstellungen, keine Störungen, Reset</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineCheck</name>
    <message>
        <source>Serial port</source>
        <translation>Serieller Anschluss</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Silence before asking</source>
        <translation>Stille vor dem Fragen</translation>
    </message>
    <message>
        <source>Any encoder</source>
        <translation>Irgendein Geber</translation>
    </message>
    <message>
        <source>Encoder %1</source>
        <translation>Geber %1</translation>
    </message>
    <message>
        <source>Not tested: the test was ended.</source>
        <translation>Nicht geprüft: Der Test wurde beendet.</translation>
    </message>
    <message>
        <source>Not tested, because of what failed before.</source>
        <translation>Nicht geprüft, weil etwas davor fehlgeschlagen ist.</translation>
    </message>
    <message>
        <source>The port %1 is there.</source>
        <translation>Der Anschluss %1 ist da.</translation>
    </message>
    <message>
        <source>Opened at %1 Bd.</source>
        <translation>Mit %1 Bd geöffnet.</translation>
    </message>
    <message>
        <source>The adapter does not grant low latency: it may collect bytes for up to 16 ms, which halves the rate of positions.</source>
        <translation>Der Adapter gewährt keine kurze Latenz: Er kann Bytes bis zu 16 ms lang sammeln, was die Rate der Positionen halbiert.</translation>
    </message>
    <message>
        <source>Nothing came within %1 ms.</source>
        <translation>Innerhalb von %1 ms kam nichts.</translation>
    </message>
    <message numerus="yes">
        <source>%n bytes came before anything was asked: another master works on this line, or something sends by itself. Nothing was sent.</source>
        <translation>
            <numerusform>%n Byte kam, bevor etwas gefragt wurde: An dieser Leitung arbeitet ein anderer Master, oder etwas sendet von selbst. Nichts wurde gesendet.</numerusform>
            <numerusform>%n Bytes kamen, bevor etwas gefragt wurde: An dieser Leitung arbeitet ein anderer Master, oder etwas sendet von selbst. Nichts wurde gesendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bytes came, but no answer of an encoder. Check baud rate and format, and whether two encoders answer at once.</source>
        <translation>
            <numerusform>%n Byte kam, aber keine Antwort eines Gebers. Prüfen Sie Baudrate und Format, und ob zwei Geber zugleich antworten.</numerusform>
            <numerusform>%n Bytes kamen, aber keine Antwort eines Gebers. Prüfen Sie Baudrate und Format, und ob zwei Geber zugleich antworten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only the request came back: the adapter hears itself, and no encoder answers. Check address, wires and supply.</source>
        <translation>Nur die Anfrage kam zurück: Der Adapter hört sich selbst, und kein Geber antwortet. Prüfen Sie Adresse, Adern und Versorgung.</translation>
    </message>
    <message>
        <source>Nothing came. Check address, baud rate, wires (A and B may be swapped) and supply; an RS-422 encoder also needs ST (pin 7) at +UB.</source>
        <translation>Nichts kam. Prüfen Sie Adresse, Baudrate, Adern (A und B können vertauscht sein) und Versorgung; ein RS-422-Geber braucht außerdem ST (Pin 7) an +UB.</translation>
    </message>
    <message>
        <source>It answers, but not with a position: %1.</source>
        <translation>Er antwortet, aber nicht mit einer Position: %1.</translation>
    </message>
    <message>
        <source>It answers after %1 ms: position %2 (%3h).</source>
        <translation>Er antwortet nach %1 ms: Position %2 (%3h).</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineChecks</name>
    <message>
        <source>Asking for positions</source>
        <translation>Abfrage der Positionen</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>Nobody asks for positions: that was stopped. Start it.</source>
        <translation>Niemand fragt Positionen ab: das wurde angehalten. Starten.</translation>
    </message>
    <message numerus="yes">
        <source>none for %n requests</source>
        <translation>
            <numerusform>keine auf %n Anfrage</numerusform>
            <numerusform>keine auf %n Anfragen</numerusform>
        </translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>some after each request</source>
        <translation>einige nach jeder Anfrage</translation>
    </message>
    <message>
        <source>they come</source>
        <translation>kommen an</translation>
    </message>
    <message>
        <source>Rate and format</source>
        <translation>Baudrate und Format</translation>
    </message>
    <message numerus="yes">
        <source>%n bytes that are no answer</source>
        <translation>
            <numerusform>%n Byte, das keine Antwort ist</numerusform>
            <numerusform>%n Bytes, die keine Antwort sind</numerusform>
        </translation>
    </message>
    <message>
        <source>the bytes make sense</source>
        <translation>lesbar</translation>
    </message>
    <message>
        <source>More than the echo</source>
        <translation>Nicht nur Echo</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>only the request came back</source>
        <translation>nur das Echo der Anfrage</translation>
    </message>
    <message>
        <source>Answer of the encoder</source>
        <translation>Antwort des Gebers</translation>
    </message>
    <message>
        <source>to each request</source>
        <translation>auf jede Anfrage</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>after %1 ms</source>
        <translation>nach %1 ms</translation>
    </message>
    <message>
        <source>Alarms and warnings</source>
        <translation>Alarme und Warnungen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineFaults</name>
    <message>
        <source>Have its battery replaced, and check the position.</source>
        <translation>Batterie ersetzen lassen und die Position prüfen.</translation>
    </message>
    <message>
        <source>Switch it off and on; if the alarm comes back, replace the encoder.</source>
        <translation>Aus- und einschalten; kommt der Alarm wieder, den Geber ersetzen.</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>stumm</translation>
    </message>
    <message>
        <source>No encoder answers on %1 at %2 Bd. Check the wires (A and B may be swapped), the supply of the encoders, and the baud rate.</source>
        <translation>Kein Geber antwortet an %1 mit %2 Bd. Adern (A und B können vertauscht sein), Versorgung der Geber und Baudrate prüfen.</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>%1 warns: %2. See to it before it becomes an alarm.</source>
        <translation>%1 warnt: %2. Beheben, bevor ein Alarm daraus wird.</translation>
    </message>
    <message>
        <source>Let it cool down, and find out what heats it.</source>
        <translation>Abkühlen lassen und nachsehen, was ihn erwärmt.</translation>
    </message>
    <message>
        <source>%1 reports an alarm: %2. %3</source>
        <translation>%1 meldet einen Alarm: %2. %3</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineFaultsBox</name>
    <message>
        <source>Lost bytes</source>
        <translation>Verlorene Bytes</translation>
    </message>
    <message>
        <source>Of 1000 bytes, both ways; they never arrive</source>
        <translation>Von 1000 Bytes, in beiden Richtungen; sie kommen nie an</translation>
    </message>
    <message>
        <source>Wrong bytes</source>
        <translation>Falsche Bytes</translation>
    </message>
    <message>
        <source>Of 1000 bytes, both ways; one bit is another</source>
        <translation>Von 1000 Bytes, in beiden Richtungen; ein Bit ist gekippt</translation>
    </message>
    <message>
        <source>Doubled bytes</source>
        <translation>Doppelte Bytes</translation>
    </message>
    <message>
        <source>Of 1000 bytes, both ways; they arrive twice</source>
        <translation>Von 1000 Bytes, in beiden Richtungen; sie kommen zweimal an</translation>
    </message>
    <message>
        <source>Delayed bytes</source>
        <translation>Verzögerte Bytes</translation>
    </message>
    <message>
        <source>Of 1000 bytes, both ways; they and all behind them come later</source>
        <translation>Von 1000 Bytes, in beiden Richtungen; sie und alle dahinter kommen später</translation>
    </message>
    <message>
        <source>Echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>The adapter hears what it sends: half duplex, as RS-485 may do</source>
        <translation>Der Adapter hört, was er sendet: halbduplex, wie es bei RS-485 sein kann</translation>
    </message>
    <message>
        <source>All encoders silent</source>
        <translation>Alle Geber stumm</translation>
    </message>
    <message>
        <source>They receive and act, but do not answer</source>
        <translation>Sie empfangen und handeln, antworten aber nicht</translation>
    </message>
    <message>
        <source>Adapter unplugged</source>
        <translation>Adapter abgezogen</translation>
    </message>
    <message>
        <source>The port is gone until it is plugged in again</source>
        <translation>Der Anschluss ist weg, bis er wieder eingesteckt ist</translation>
    </message>
    <message>
        <source>%1, of 1000</source>
        <translation>%1, von 1000</translation>
    </message>
    <message>
        <source>Delay in ms</source>
        <translation>Verzögerung in ms</translation>
    </message>
    <message>
        <source>How much later a delayed byte comes, in ms</source>
        <translation>Wie viel später ein verzögertes Byte kommt, in ms</translation>
    </message>
    <message>
        <source>Delay, ms</source>
        <translation>Verzögerung, ms</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineFiguresModel</name>
    <message>
        <source>Line</source>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Time-outs</source>
        <translation>Zeitüberschreitungen</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Unanswered</source>
        <translation>Unbeantwortet</translation>
    </message>
    <message>
        <source>Garbage bytes</source>
        <translation>Störbytes</translation>
    </message>
    <message>
        <source>Late bytes</source>
        <translation>Verspätete Bytes</translation>
    </message>
    <message>
        <source>Answer time, shortest, ms</source>
        <translation>Antwortzeit, kürzeste, ms</translation>
    </message>
    <message>
        <source>Answer time, median, ms</source>
        <translation>Antwortzeit, Median, ms</translation>
    </message>
    <message>
        <source>Answer time, longest, ms</source>
        <translation>Antwortzeit, längste, ms</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineKeeper</name>
    <message>
        <source>Serial line</source>
        <translation>Serielle Leitung</translation>
    </message>
    <message>
        <source>Fraction bits of the scaling factor</source>
        <translation>Nachkommabits des Skalierungsfaktors</translation>
    </message>
    <message>
        <source>Baud rate of the serial line</source>
        <translation>Baudrate der seriellen Leitung</translation>
    </message>
    <message>
        <source>Encoders of the serial line</source>
        <translation>Geber der seriellen Leitung</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Address of %1 to %2</source>
        <translation>Adresse von %1 auf %2</translation>
    </message>
    <message>
        <source>Warning bytes of %1</source>
        <translation>Warnungsbytes von %1</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineKind</name>
    <message>
        <source>Serial line (ESC)</source>
        <translation>Serielle Leitung (ESC)</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>Line</source>
        <comment>name of a new bus</comment>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>training line (simulated)</source>
        <translation>Übungsleitung (simuliert)</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineOutline</name>
    <message>
        <source>Serial line</source>
        <translation>Serielle Leitung</translation>
    </message>
    <message>
        <source>Serial line (%1)</source>
        <translation>Serielle Leitung (%1)</translation>
    </message>
    <message>
        <source>%1  %2
Address %3
State: %4</source>
        <translation>%1  %2
Adresse %3
Zustand: %4</translation>
    </message>
    <message>
        <source>%1, %2 Bd
State: %3
Answers: %4, time-outs: %5</source>
        <translation>%1, %2 Bd
Zustand: %3
Antworten: %4, Zeitüberschreitungen: %5</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>sucht</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>jobs end, and nothing that waits is sent; positions are still read</source>
        <translation>Aufträge enden, und nichts Wartendes wird gesendet; Positionen werden weiter gelesen</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>offline</translation>
    </message>
    <message>
        <source>no port</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgetrennt</translation>
    </message>
    <message>
        <source>job</source>
        <comment>it is running</comment>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>suspect</source>
        <comment>position</comment>
        <translation>fraglich</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLinePanel</name>
    <message>
        <source>Serial line</source>
        <translation>Serielle Leitung</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>The serial port of this line</source>
        <translation>Der serielle Anschluss dieser Leitung</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Bits per second; data bits, parity, stop bits</source>
        <translation>Bits pro Sekunde; Datenbits, Parität, Stoppbits</translation>
    </message>
    <message>
        <source>Polling</source>
        <translation>Abfrage</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>In Watch only reads are sent</source>
        <translation>In Beobachten wird nur gelesen</translation>
    </message>
    <message>
        <source>Figures of the line and its encoders</source>
        <translation>Statistik der Leitung und ihrer Geber</translation>
    </message>
    <message>
        <source>Since the line was opened. Times are from the end of a request to the end of its answer; the median is that of the newest 1000.</source>
        <translation>Seit dem Öffnen der Leitung. Die Zeiten gehen vom Ende einer Anfrage bis zum Ende ihrer Antwort; der Median gilt für die neuesten 1000.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>The port is gone; it is looked for each second</source>
        <translation>Der Anschluss ist weg; er wird jede Sekunde gesucht</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>%1 Bd, %2</source>
        <translation>%1 Bd, %2</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>Operate: allowed</source>
        <translation>Bedienen: erlaubt</translation>
    </message>
    <message>
        <source>Watch: only reads are sent</source>
        <translation>Beobachten: Es wird nur gelesen</translation>
    </message>
    <message>
        <source>%1 rows of the terminal were lost: the window was busy for too long.</source>
        <translation>%1 Zeilen des Terminals gingen verloren: Das Fenster war zu lange beschäftigt.</translation>
    </message>
    <message>
        <source>granted</source>
        <comment>low latency, by the adapter</comment>
        <translation>gewährt</translation>
    </message>
    <message>
        <source>refused by the adapter: answers may come up to 16 ms later</source>
        <translation>vom Adapter abgelehnt: Antworten können bis zu 16 ms später kommen</translation>
    </message>
    <message>
        <source>not asked for</source>
        <comment>low latency</comment>
        <translation>nicht verlangt</translation>
    </message>
    <message>
        <source>Low latency</source>
        <translation>Kurze Latenz</translation>
    </message>
    <message>
        <source>Whether the adapter hands over bytes at once. Where it does not, time-outs are longer, and positions come more slowly</source>
        <translation>Ob der Adapter Bytes sofort weitergibt. Tut er es nicht, gelten längere Zeitgrenzen, und Positionen kommen langsamer</translation>
    </message>
    <message>
        <source>Another adapter is plugged in</source>
        <translation>Ein anderer Adapter ist eingesteckt</translation>
    </message>
    <message>
        <source>Whether the encoders are asked in turn</source>
        <translation>Ob die Geber reihum abgefragt werden</translation>
    </message>
    <message>
        <source>no adapter to ask</source>
        <translation>kein Adapter da</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLinePlanRules</name>
    <message>
        <source>Address %1</source>
        <translation>Adresse %1</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineRecordView</name>
    <message>
        <source>Rows of the saved session</source>
        <translation>Zeilen der Aufzeichnung</translation>
    </message>
    <message>
        <source>Requests sent again</source>
        <translation>Noch einmal gesendete Anfragen</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Wiedergeben</translation>
    </message>
    <message>
        <source>Sends the requests of this session again, and compares the answers (Alt+R)</source>
        <translation>Sendet die Anfragen dieser Aufzeichnung noch einmal und vergleicht die Antworten (Alt+W)</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Sends no more of them (Alt+L)</source>
        <translation>Sendet keine weiteren (Alt+B)</translation>
    </message>
    <message>
        <source>Bac&amp;k to the line</source>
        <translation>&amp;Zurück zur Leitung</translation>
    </message>
    <message>
        <source>Closes this session (Alt+K)</source>
        <translation>Schließt diese Aufzeichnung (Alt+Z)</translation>
    </message>
    <message>
        <source>%1: %2, %3 Bd, %4; %5 rows</source>
        <comment>file, port, baud rate, date and time, count</comment>
        <translation>%1: %2, %3 Bd, %4; %5 Zeilen</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, listed below</source>
        <translation>
            <numerusform>und %n weitere, unten aufgeführt</numerusform>
            <numerusform>und %n weitere, unten aufgeführt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of the %2 requests write to encoders: %3.</source>
        <translation>Davon schreiben in Geber: %1 von %2 Anfragen: %3.</translation>
    </message>
    <message>
        <source>Send re&amp;ads only</source>
        <translation>&amp;Nur Lesendes senden</translation>
    </message>
    <message>
        <source>Send &amp;writes too</source>
        <translation>Auch &amp;Schreibendes senden</translation>
    </message>
    <message>
        <source>The program only watches: they are left out. Switch to Operate to send them.</source>
        <translation>Das Programm beobachtet nur: Sie werden ausgelassen. Zum Senden auf Bedienen schalten.</translation>
    </message>
    <message>
        <source>Sent: %1 of %2. The answer was the same: %3, another: %4, none came: %5.</source>
        <translation>Gesendet: %1 von %2. Die Antwort war gleich: %3, anders: %4, blieb aus: %5.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The serial line is gone.</source>
        <translation>Die serielle Leitung ist weg.</translation>
    </message>
    <message>
        <source>The program only watches now: the next request writes.</source>
        <translation>Das Programm beobachtet jetzt nur: Die nächste Anfrage schreibt.</translation>
    </message>
    <message>
        <source>The serial line is not open. Connect it first.</source>
        <translation>Die serielle Leitung ist nicht offen. Zuerst verbinden.</translation>
    </message>
    <message>
        <source>This session contains no request to send, except automatic ones: clear &quot;Hide automatic requests&quot; to send those again.</source>
        <translation>Diese Aufzeichnung enthält außer automatischen Anfragen keine Anfrage zum Senden: „Automatische Anfragen ausblenden“ abwählen, um diese zu senden.</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineRowOptions</name>
    <message>
        <source>Shows the bytes as text, control characters as pictures</source>
        <translation>Zeigt die Bytes als Text, Steuerzeichen als Symbole</translation>
    </message>
    <message>
        <source>Shows the bytes as hexadecimal numbers</source>
        <translation>Zeigt die Bytes als Hexzahlen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>Hide automatic requests</source>
        <translation>Automatische Anfragen ausblenden</translation>
    </message>
    <message>
        <source>Leaves out what the program asks by itself (position, warnings, alarms, serial number, version, device code) and the answers. They are kept, and shown again when this is cleared.</source>
        <translation>Blendet aus, was das Programm von selbst fragt (Position, Warnungen, Alarme, Seriennummer, Version, Gerätecode), samt den Antworten. Sie bleiben erhalten und erscheinen wieder, wenn dies ausgeschaltet wird.</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineSearch</name>
    <message>
        <source>Two hexadecimal digits, 01 to 1F</source>
        <translation>Zwei Hexziffern, 01 bis 1F</translation>
    </message>
    <message>
        <source>First address</source>
        <translation>Erste Adresse</translation>
    </message>
    <message>
        <source>Last address</source>
        <translation>Letzte Adresse</translation>
    </message>
    <message>
        <source>Ask at the &amp;master address 00 first</source>
        <translation>Zuerst die Masteradresse 00 ab&amp;fragen</translation>
    </message>
    <message>
        <source>No search yet</source>
        <translation>Noch keine Suche</translation>
    </message>
    <message>
        <source>Each address is asked for its serial number. Nothing is written.</source>
        <translation>Von jeder Adresse wird die Seriennummer abgefragt. Nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>Search for encoders</source>
        <translation>Geber suchen</translation>
    </message>
    <message>
        <source>&amp;Take over</source>
        <translation>Überneh&amp;men</translation>
    </message>
    <message>
        <source>Adds the ticked encoders to the bus structure</source>
        <translation>Nimmt die angehakten Geber in den Busaufbau auf</translation>
    </message>
    <message>
        <source>t&amp;o</source>
        <translation>b&amp;is</translation>
    </message>
    <message>
        <source>&amp;Addresses</source>
        <translation>Adresse&amp;n</translation>
    </message>
    <message>
        <source>%1 Bd</source>
        <translation>%1 Bd</translation>
    </message>
    <message>
        <source>All three baud rates</source>
        <translation>Alle drei Baudraten</translation>
    </message>
    <message>
        <source>Baud rates of the search</source>
        <translation>Baudraten der Suche</translation>
    </message>
    <message>
        <source>An encoder answers at its own baud rate alone; 19200 is that of the factory</source>
        <translation>Ein Geber antwortet nur mit seiner eigenen Baudrate; ab Werk sind es 19200</translation>
    </message>
    <message>
        <source>Baud &amp;rate</source>
        <translation>Baud&amp;rate</translation>
    </message>
    <message>
        <source>Any encoder answers there: only where a single one is on the line, since several would answer at once</source>
        <translation>Dort antwortet jeder Geber: nur verwenden, wenn ein einziger an der Leitung ist, denn mehrere antworten zugleich</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>S&amp;uchen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Ends the search</source>
        <translation>Beendet die Suche</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>Encoders found</source>
        <translation>Gefundene Geber</translation>
    </message>
    <message>
        <source>Space chooses an encoder</source>
        <translation>Die Leertaste wählt einen Geber</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Sucht</translation>
    </message>
    <message>
        <source>%1 of %2 asked</source>
        <translation>%1 von %2 abgefragt</translation>
    </message>
    <message numerus="yes">
        <source>Requests sent: %n.</source>
        <translation>
            <numerusform>Gesendete Anfragen: %n.</numerusform>
            <numerusform>Gesendete Anfragen: %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Encoders found: %n.</source>
        <translation>
            <numerusform>Gefundene Geber: %n.</numerusform>
            <numerusform>Gefundene Geber: %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>The search was cancelled.</source>
        <translation>Suche abgebrochen.</translation>
    </message>
    <message>
        <source>The search was cancelled</source>
        <translation>Die Suche wurde abgebrochen</translation>
    </message>
    <message>
        <source>No encoder has answered</source>
        <translation>Kein Geber hat geantwortet</translation>
    </message>
    <message>
        <source>Check: the address and the baud rate (search all three); the wiring, both pairs the right way round, termination; the supply of the encoder; with RS-422 that the input ST (pin 7) is tied to +UB, without it no command works.</source>
        <translation>Prüfen: Adresse und Baudrate (alle drei absuchen); Verdrahtung (beide Paare richtig herum) und Abschluss; Versorgung des Gebers; bei RS-422, dass der Eingang ST (Pin 7) an +UB liegt: Ohne das wirkt kein Befehl.</translation>
    </message>
    <message>
        <source>Asks one address after the other (Alt+S)</source>
        <translation>Fragt eine Adresse nach der anderen (Alt+U)</translation>
    </message>
    <message>
        <source>The serial line is not open. Connect it first.</source>
        <translation>Die serielle Leitung ist nicht offen. Zuerst verbinden.</translation>
    </message>
    <message>
        <source>Kind of encoder</source>
        <translation>Art des Gebers</translation>
    </message>
    <message>
        <source>The kind that the ticked encoders are taken over as: they do not report whether they have RS-422 or RS-485</source>
        <translation>Als welche Geber die angehakten übernommen werden: Sie melden nicht, ob sie RS-422 oder RS-485 haben</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>Ar&amp;t</translation>
    </message>
    <message>
        <source>Not taken over: %1. The line runs at %2 Bd. Choose the other baud rate in the settings of the line, and connect it again.</source>
        <translation>Nicht übernommen: %1. Die Leitung arbeitet mit %2 Bd. In den Einstellungen der Leitung die andere Baudrate wählen und neu verbinden.</translation>
    </message>
    <message>
        <source>%1 at %2 Bd</source>
        <translation>%1 mit %2 Bd</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address. Give two hexadecimal digits, 01 to 1F.</source>
        <translation>„%1“ ist keine Adresse. Zwei Hexziffern angeben, 01 bis 1F.</translation>
    </message>
    <message>
        <source>Asks encoders for their serial numbers. Nothing is written.</source>
        <translation>Fragt Geber nach ihrer Seriennummer. Geschrieben wird nichts.</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineSettingsForm</name>
    <message>
        <source> ms</source>
        <comment>unit of a time</comment>
        <translation> ms</translation>
    </message>
    <message>
        <source>Settings of the serial line</source>
        <translation>Einstellungen der seriellen Leitung</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>An&amp;schluss</translation>
    </message>
    <message>
        <source>Ba&amp;ud rate</source>
        <translation>Ba&amp;udrate</translation>
    </message>
    <message>
        <source>19200, 9600 or 4800; any other may be typed. 19200 is that of the factory</source>
        <translation>19200, 9600 oder 4800; jede andere lässt sich eintippen. Ab Werk sind es 19200</translation>
    </message>
    <message>
        <source>Dat&amp;a bits</source>
        <translation>Date&amp;nbits</translation>
    </message>
    <message>
        <source>8 for these encoders</source>
        <translation>8 bei diesen Gebern</translation>
    </message>
    <message>
        <source>Parit&amp;y</source>
        <translation>&amp;Parität</translation>
    </message>
    <message>
        <source>None for these encoders</source>
        <translation>Keine bei diesen Gebern</translation>
    </message>
    <message>
        <source>&amp;Stop bits</source>
        <translation>Stoppb&amp;its</translation>
    </message>
    <message>
        <source>2 for these encoders</source>
        <translation>2 bei diesen Gebern</translation>
    </message>
    <message>
        <source>none</source>
        <comment>parity</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>even</source>
        <comment>parity</comment>
        <translation>gerade</translation>
    </message>
    <message>
        <source>odd</source>
        <comment>parity</comment>
        <translation>ungerade</translation>
    </message>
    <message>
        <source>Poll &amp;interval</source>
        <translation>Abfrageinterval&amp;l</translation>
    </message>
    <message>
        <source>Between position requests of one encoder; 10 ms is the shortest of the manual</source>
        <translation>Zwischen den Positionsanfragen eines Gebers; kürzester Wert laut Handbuch: 10 ms</translation>
    </message>
    <message>
        <source>From the end of a request to the beginning of its answer</source>
        <translation>Vom Ende einer Anfrage bis zum Anfang ihrer Antwort</translation>
    </message>
    <message>
        <source>&amp;Number of retries</source>
        <translation>Anzahl der &amp;Wiederholungen</translation>
    </message>
    <message>
        <source>How often a read is sent again. A write never is</source>
        <translation>Wie oft ein Lesen noch einmal gesendet wird. Ein Schreiben nie</translation>
    </message>
    <message>
        <source>&amp;Quiet time after a write</source>
        <translation>&amp;Ruhezeit nach einem Schreiben</translation>
    </message>
    <message>
        <source>How long nothing is sent after a write: the encoder stores it</source>
        <translation>Wie lange nach einem Schreiben nichts gesendet wird: Solange speichert der Geber</translation>
    </message>
    <message>
        <source>Fraction bits of the scalin&amp;g factor</source>
        <translation>Nachkommabits des Skalierungs&amp;faktors</translation>
    </message>
    <message>
        <source>29 fits the example of the manual; it can be determined from a device</source>
        <translation>29 passt zum Beispiel des Handbuchs; der Wert lässt sich am Gerät bestimmen</translation>
    </message>
    <message>
        <source>A position that jumps further than this speed allows is marked suspect and asked for again</source>
        <translation>Eine Position, die weiter springt, als diese Drehzahl erlaubt, gilt als verdächtig und wird noch einmal abgefragt</translation>
    </message>
    <message>
        <source>Choose a serial port, or type the path of one.</source>
        <translation>Einen seriellen Anschluss wählen oder den Pfad eintippen.</translation>
    </message>
    <message>
        <source>Fraction bits of the scaling factor</source>
        <translation>Nachkommabits des Skalierungsfaktors</translation>
    </message>
    <message>
        <source>Deter&amp;mine</source>
        <translation>Besti&amp;mmen</translation>
    </message>
    <message>
        <source>Reads scaling factor, steps per turn and measuring range of the chosen encoder of the line, or else of the first that answers, and keeps the format that fits. Nothing is written (Alt+M)</source>
        <translation>Liest Skalierungsfaktor, Schritte je Umdrehung und Messbereich des gewählten Gebers der Leitung, sonst des ersten, der antwortet, und behält das passende Format. Es wird nichts geschrieben (Alt+M)</translation>
    </message>
    <message>
        <source>Set the line to %1 Bd</source>
        <translation>Leitung auf %1 Bd stellen</translation>
    </message>
    <message>
        <source>The baud rate is a number from %1 to %2.</source>
        <translation>Die Baudrate ist eine Zahl von %1 bis %2.</translation>
    </message>
    <message>
        <source> rpm</source>
        <comment>revolutions per minute</comment>
        <translation> U/min</translation>
    </message>
    <message>
        <source>Lo&amp;w latency</source>
        <translation>&amp;Kurze Latenz</translation>
    </message>
    <message>
        <source>Asks the adapter to hand over bytes at once. Many collect them for up to 16 ms (Alt+W)</source>
        <translation>Bittet den Adapter, Bytes sofort weiterzugeben. Viele sammeln sie bis zu 16 ms lang (Alt+K)</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Serieller Anschluss</translation>
    </message>
    <message>
        <source>Encoders at a serial adapter. From connecting on they are asked for positions.</source>
        <translation>Geber an einem seriellen Adapter. Ab dem Verbinden werden sie nach Positionen gefragt.</translation>
    </message>
    <message>
        <source>Without it many adapters collect bytes for up to 16 ms</source>
        <translation>Ohne sie sammeln viele Adapter Bytes bis zu 16 ms lang</translation>
    </message>
    <message>
        <source>Time-&amp;out</source>
        <translation>&amp;Zeitgrenze</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>Maximale Drehzahl</translation>
    </message>
    <message>
        <source>Ma&amp;ximum speed</source>
        <translation>Ma&amp;ximale Drehzahl</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineStatus</name>
    <message>
        <source>%1: port is gone</source>
        <comment>serial port</comment>
        <translation>%1: Anschluss ist weg</translation>
    </message>
    <message>
        <source>%1, %2 Bd, %3 of %4 answer</source>
        <comment>serial port, baud rate, encoders</comment>
        <translation>%1, %2 Bd, %3 von %4 antworten</translation>
    </message>
    <message>
        <source>Serial line: %1 answers, %2 time-outs, %3 garbage bytes</source>
        <translation>Serielle Leitung: %1 Antworten, %2 Zeitüberschreitungen, %3 Störbytes</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineTerminal</name>
    <message>
        <source>Nothing was sent: a job is running on this line. Wait until it has ended, or cancel it.</source>
        <translation>Nichts gesendet: An dieser Leitung läuft ein Auftrag. Sein Ende abwarten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>Send and &amp;write</source>
        <translation>Senden und sch&amp;reiben</translation>
    </message>
    <message>
        <source>Do &amp;not send</source>
        <translation>&amp;Nicht senden</translation>
    </message>
    <message>
        <source>No answer to %1. Whether it was carried out is unknown: read the value back. It is not sent again by itself.</source>
        <translation>Keine Antwort auf %1. Ob es ausgeführt wurde, ist unbekannt: Den Wert zurücklesen. Von selbst wird es nicht noch einmal gesendet.</translation>
    </message>
    <message>
        <source>No answer to %1. Check address and baud rate, or look for encoders.</source>
        <translation>Keine Antwort auf %1. Adresse und Baudrate prüfen oder Geber suchen.</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>line-session.json</source>
        <comment>name of a file</comment>
        <translation>leitung.json</translation>
    </message>
    <message>
        <source>Line sessions (*.json)</source>
        <translation>Aufzeichnungen (*.json)</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Export the rows</source>
        <translation>Zeilen exportieren</translation>
    </message>
    <message>
        <source>line.txt</source>
        <comment>name of a file</comment>
        <translation>leitung.txt</translation>
    </message>
    <message>
        <source>Address and command, as in 05P. Up and Down: what was typed before. Ctrl+Space: all commands.</source>
        <translation>Adresse und Befehl, etwa 05P. Auf und Ab: zuvor Getipptes. Strg+Leertaste: alle Befehle.</translation>
    </message>
    <message>
        <source>Sends the request (Enter)</source>
        <translation>Sendet die Anfrage (Eingabe)</translation>
    </message>
    <message>
        <source>Line terminal</source>
        <translation>Leitungsterminal</translation>
    </message>
    <message>
        <source>Nothing has passed on the line yet</source>
        <translation>Noch ging nichts über die Leitung</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keep the newest row in view</source>
        <translation>Automatisch folgen: Die neueste Zeile bleibt im Blick</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all shown, with tabs between the columns</source>
        <translation>Die gewählten oder alle gezeigten Zeilen kopieren, mit Tabulatoren zwischen den Spalten</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Look at a saved session, and send it again</source>
        <translation>Eine Aufzeichnung ansehen und noch einmal senden</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the rows shown to a text file</source>
        <translation>Die gezeigten Zeilen in eine Textdatei schreiben</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove all rows</source>
        <translation>Alle Zeilen entfernen</translation>
    </message>
    <message>
        <source>Request to send</source>
        <translation>Anfrage zum Senden</translation>
    </message>
    <message>
        <source>Send the request</source>
        <translation>Die Anfrage senden</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Show the rows again that Clear removed</source>
        <translation>Die mit Leeren entfernten Zeilen wieder zeigen</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Traffic on the line</source>
        <translation>Was über die Leitung ging</translation>
    </message>
    <message>
        <source>What is sent and answered on a serial line is shown here. Connect one, or open a saved session.</source>
        <translation>Hier steht, was auf einer seriellen Leitung gesendet und geantwortet wird. Eine Leitung verbinden oder eine Aufzeichnung öffnen.</translation>
    </message>
    <message>
        <source>Hold the table; new rows are kept and shown afterwards</source>
        <translation>Die Tabelle anhalten; neue Zeilen bleiben erhalten und erscheinen danach</translation>
    </message>
    <message>
        <source>Save all rows in a file, to look at and send again</source>
        <translation>Alle Zeilen in einer Datei ablegen, zum Ansehen und erneuten Senden</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineTrainingPanel</name>
    <message>
        <source>The simulated line, or the encoder on it, that is moved and disturbed here</source>
        <translation>Die simulierte Leitung, oder der Geber daran, der hier bewegt und gestört wird</translation>
    </message>
    <message>
        <source>Serial line</source>
        <translation>Serielle Leitung</translation>
    </message>
</context>
<context>
    <name>codewheel::EscLineViews</name>
    <message>
        <source>&amp;Use this adapter</source>
        <translation>Diesen Adapter ver&amp;wenden</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Asks for positions again</source>
        <translation>Fragt wieder nach Positionen</translation>
    </message>
    <message>
        <source>Request field of the terminal</source>
        <translation>Eingabefeld des Terminals</translation>
    </message>
    <message>
        <source>Training line</source>
        <translation>Übungsleitung</translation>
    </message>
    <message>
        <source>Three simulated encoders, at factory settings, in this program. Nothing leaves this computer.</source>
        <translation>Drei simulierte Geber mit Werkseinstellungen in diesem Programm. Nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>Use this adapter</source>
        <translation>Diesen Adapter verwenden</translation>
    </message>
    <message>
        <source>The line is not connected.</source>
        <translation>Die Leitung ist nicht verbunden.</translation>
    </message>
</context>
<context>
    <name>codewheel::FaultBanner</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Chooses the place of the fault, and shows what is known of it</source>
        <translation>Wählt den Platz der Störung und zeigt, was davon bekannt ist</translation>
    </message>
    <message>
        <source>The other faults; choose one to see where it is</source>
        <translation>Die anderen Störungen; eine wählen, um zu sehen, wo sie ist</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>bus: its fault</comment>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>faults</comment>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Other faults</source>
        <translation>Weitere Störungen</translation>
    </message>
    <message>
        <source>What can be done</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>What can be done about the fault</source>
        <translation>Was gegen die Störung getan werden kann</translation>
    </message>
</context>
<context>
    <name>codewheel::FaultPlan</name>
    <message>
        <source>Wire break before it</source>
        <translation>Drahtbruch davor</translation>
    </message>
    <message>
        <source>CRC errors in the segment</source>
        <translation>CRC-Fehler im Segment</translation>
    </message>
    <message>
        <source>Device without supply</source>
        <translation>Teilnehmer ohne Versorgung</translation>
    </message>
    <message>
        <source>Wrong device in place</source>
        <translation>Falsches Gerät am Platz</translation>
    </message>
    <message>
        <source>Peripheral fault</source>
        <translation>Peripheriefehler</translation>
    </message>
    <message>
        <source>Encoder switched off</source>
        <translation>Geber ausgeschaltet</translation>
    </message>
    <message>
        <source>Slow confirmation</source>
        <translation>Langsame Quittung</translation>
    </message>
    <message>
        <source>EEPROM worn out</source>
        <translation>EEPROM verschlissen</translation>
    </message>
    <message>
        <source>Parameters lost</source>
        <translation>Parameter verloren</translation>
    </message>
    <message>
        <source>Battery low</source>
        <translation>Batterie schwach</translation>
    </message>
    <message>
        <source>Code disc faulty</source>
        <translation>Codescheibe defekt</translation>
    </message>
    <message>
        <source>Cam out of range</source>
        <translation>Nocken außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Magnet lost</source>
        <translation>Magnet verloren</translation>
    </message>
    <message>
        <source>%1: %2, %3 of 1000 cycles</source>
        <translation>%1: %2, %3 von 1000 Zyklen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 is over</source>
        <translation>%1: %2 ist vorbei</translation>
    </message>
</context>
<context>
    <name>codewheel::FaultPlanBar</name>
    <message>
        <source>Loads a file of faults with their times and places</source>
        <translation>Lädt eine Datei mit Fehlern, ihren Zeiten und Orten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Carries out the fault plan from its beginning</source>
        <translation>Führt den Fehlerplan von Anfang an aus</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Ends the fault plan; what it has caused stays</source>
        <translation>Beendet den Fehlerplan; was er bewirkt hat, bleibt</translation>
    </message>
    <message>
        <source>Fault plan</source>
        <translation>Fehlerplan</translation>
    </message>
    <message>
        <source>In %1 s: %2</source>
        <translation>In %1 s: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n steps</source>
        <translation>
            <numerusform>%1: %n Schritt</numerusform>
            <numerusform>%1: %n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Fault plan…</source>
        <translation>Fehlerplan…</translation>
    </message>
    <message>
        <source>Fault plans (*.cwfaults *.json)</source>
        <translation>Fehlerpläne (*.cwfaults *.json)</translation>
    </message>
</context>
<context>
    <name>codewheel::FaultPlanReader</name>
    <message>
        <source>This is not a fault plan: the format is not &quot;%1&quot;.</source>
        <translation>Das ist kein Fehlerplan: Das Format ist nicht „%1“.</translation>
    </message>
    <message>
        <source>Only version %1 of the format can be read.</source>
        <translation>Nur Version %1 des Formats lässt sich lesen.</translation>
    </message>
    <message>
        <source>At least one step is expected here.</source>
        <translation>Hier wird mindestens ein Schritt erwartet.</translation>
    </message>
    <message>
        <source>The device at %1 cannot have this fault.</source>
        <translation>Der Teilnehmer %1 kann diesen Fehler nicht haben.</translation>
    </message>
    <message>
        <source>There is no device at &quot;%1&quot;.</source>
        <translation>Es gibt keinen Teilnehmer „%1“.</translation>
    </message>
    <message>
        <source>CRC errors have &quot;perThousand&quot; in place of it.</source>
        <translation>CRC-Fehler haben stattdessen &quot;perThousand&quot;.</translation>
    </message>
    <message>
        <source>Only CRC errors have a rate.</source>
        <translation>Nur CRC-Fehler haben eine Rate.</translation>
    </message>
    <message>
        <source>Lost parameters come back by parameterizing the encoder only.</source>
        <translation>Verlorene Parameter lassen sich nur durch Parametrieren des Gebers wiederherstellen.</translation>
    </message>
    <message>
        <source>The step above comes later: the steps must be in the order of their times.</source>
        <translation>Der Schritt darüber kommt später: Die Schritte müssen nach ihrer Zeit geordnet sein.</translation>
    </message>
</context>
<context>
    <name>codewheel::FileAccess</name>
    <message>
        <source>It is not a file.</source>
        <translation>Es ist keine Datei.</translation>
    </message>
</context>
<context>
    <name>codewheel::FindBar</name>
    <message>
        <source>Find in this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Marks this text wherever it stands on the page</source>
        <translation>Markiert diesen Text überall auf der Seite</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>The next one (F3)</source>
        <translation>Die nächste Stelle (F3)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Not on this page</source>
        <translation>Nicht auf dieser Seite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>3 of 12 places</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The previous one (Shift+F3)</source>
        <translation>Die Stelle davor (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Ends the search (Esc)</source>
        <translation>Beendet die Suche (Esc)</translation>
    </message>
</context>
<context>
    <name>codewheel::FindPage</name>
    <message>
        <source>Ports</source>
        <translation>Anschlüsse</translation>
    </message>
    <message>
        <source>Space ticks a port or leaves it out</source>
        <translation>Leertaste: Anschluss an- oder abwählen</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>The name or address of a gateway in the network, such as 192.168.0.5; empty: none</source>
        <translation>Name oder Adresse eines Gateways im Netz, etwa 192.168.0.5; leer: keines</translation>
    </message>
    <message>
        <source>Port of the host</source>
        <translation>Port des Hosts</translation>
    </message>
    <message>
        <source>502 with nearly every gateway</source>
        <translation>502 bei fast jedem Gateway</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>A&amp;ktualisieren</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>S&amp;uchen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>Looks for serial ports again (Alt+R)</source>
        <translation>Sucht noch einmal nach seriellen Anschlüssen (Alt+K)</translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation>An&amp;schlüsse</translation>
    </message>
    <message>
        <source>Ends the search after its present step (Alt+C)</source>
        <translation>Beendet die Suche nach ihrem jetzigen Schritt (Alt+R)</translation>
    </message>
    <message>
        <source>What was heard and found</source>
        <translation>Was gehört und gefunden wurde</translation>
    </message>
    <message>
        <source>Return connects where the chosen one was found</source>
        <translation>Eingabe verbindet mit dem gewählten Fund</translation>
    </message>
    <message>
        <source>&amp;Ask</source>
        <translation>&amp;Fragen</translation>
    </message>
    <message>
        <source>Listens at the ticked ports, and then says what it would ask (Alt+S)</source>
        <translation>Horcht an den gewählten Anschlüssen und sagt dann, was gefragt würde (Alt+U)</translation>
    </message>
    <message>
        <source>Tick a port, or enter a host</source>
        <translation>Einen Anschluss wählen oder einen Host eingeben</translation>
    </message>
    <message>
        <source>Once the search has ended</source>
        <translation>Sobald die Suche beendet ist</translation>
    </message>
    <message>
        <source>Choose somebody who was found. Where a master works, it has to go first</source>
        <translation>Einen Fund wählen. Arbeitet dort ein Master, diesen zuerst abschalten</translation>
    </message>
    <message>
        <source>Who is there?</source>
        <translation>Wer ist da?</translation>
    </message>
    <message>
        <source>Listens first. What would be sent after that is asked before. Nothing is written.</source>
        <translation>Horcht zuerst. Bevor etwas gesendet wird, wird gefragt. Nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>Co&amp;nnect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>por&amp;t</source>
        <translation>Por&amp;t</translation>
    </message>
    <message>
        <source>H&amp;ost</source>
        <translation>H&amp;ost</translation>
    </message>
    <message>
        <source>Connects with the settings found, and keeps them in the project (Alt+N)</source>
        <translation>Verbindet mit den gefundenen Einstellungen und behält sie im Projekt (Alt+V)</translation>
    </message>
    <message>
        <source>Ask %1? Only reads are sent.</source>
        <translation>%1 fragen? Es wird nur gelesen.</translation>
    </message>
    <message>
        <source>Port by name</source>
        <translation>Anschluss nach Name</translation>
    </message>
    <message>
        <source>A port that is not in the list, such as a pseudo terminal; empty: none</source>
        <translation>Ein Anschluss, der nicht in der Liste steht, etwa ein Pseudoterminal; leer: keiner</translation>
    </message>
    <message>
        <source>Port by na&amp;me</source>
        <translation>&amp;Weiterer Anschluss</translation>
    </message>
    <message>
        <source>Nobody was looked for yet</source>
        <translation>Noch nichts gesucht</translation>
    </message>
    <message>
        <source>Tick the ports to listen at, or enter a host. Then press Search.</source>
        <translation>Die Anschlüsse wählen, an denen gehorcht wird, oder einen Host eingeben. Dann Suchen drücken.</translation>
    </message>
</context>
<context>
    <name>codewheel::Finder</name>
    <message>
        <source>An encoder with the Kübler ESC protocol</source>
        <translation>Ein Geber mit dem Kübler-ESC-Protokoll</translation>
    </message>
    <message>
        <source>at the master address</source>
        <translation>an der Masteradresse</translation>
    </message>
    <message>
        <source>at address %1</source>
        <translation>an Adresse %1</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>no serial number</source>
        <translation>ohne Seriennummer</translation>
    </message>
    <message>
        <source>Asks for an encoder with the Kübler ESC protocol at address %1.</source>
        <translation>Fragt nach einem Geber mit dem Kübler-ESC-Protokoll an Adresse %1.</translation>
    </message>
    <message>
        <source>A master works on this line with the Kübler ESC protocol.</source>
        <translation>An dieser Leitung arbeitet ein Master mit dem Kübler-ESC-Protokoll.</translation>
    </message>
    <message>
        <source>Kübler ESC: at 19200, 9600 and 4800 Bd, 8N2, the master address 00 is asked for a serial number, twice; where anything comes, each address from 01 to 1F is asked for serial number, device code and version.</source>
        <translation>Kübler ESC: Mit 19200, 9600 und 4800 Bd, 8N2, wird die Masteradresse 00 zweimal nach einer Seriennummer gefragt; wo etwas kommt, jede Adresse von 01 bis 1F nach Seriennummer, Gerätecode und Version.</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>wahrscheinlich</translation>
    </message>
    <message>
        <source>The host takes the connection.</source>
        <translation>Der Host nimmt die Verbindung an.</translation>
    </message>
    <message>
        <source>All were asked.</source>
        <translation>Alle wurden gefragt.</translation>
    </message>
    <message>
        <source>The host takes the connection, but no unit answers.</source>
        <translation>Der Host nimmt die Verbindung an, aber keine Unit antwortet.</translation>
    </message>
    <message>
        <source>The Modbus unit %1 does not answer.</source>
        <translation>Die Modbus-Unit %1 antwortet nicht.</translation>
    </message>
    <message>
        <source>The Modbus unit %1 answers. Whether it shows a ring, its register map says: test it.</source>
        <translation>Die Modbus-Unit %1 antwortet. Ob dahinter ein Ring liegt, zeigt Testen.</translation>
    </message>
    <message>
        <source>The line is silent. Asking may find out more.</source>
        <translation>Niemand sendet. Mehr zeigt eine Abfrage.</translation>
    </message>
    <message>
        <source>Somebody talks on this line, but it makes sense with no usual setting. Nothing was sent.</source>
        <translation>An dieser Leitung spricht jemand, aber mit keiner üblichen Einstellung ergibt es einen Sinn. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Bytes come, but none that make sense at %1.</source>
        <translation>Es kommen Bytes, die bei %1 keinen Sinn ergeben.</translation>
    </message>
    <message>
        <source>Bytes come, but none that make sense at %1: next %2.</source>
        <translation>Es kommen Bytes, die bei %1 keinen Sinn ergeben: als Nächstes %2.</translation>
    </message>
    <message>
        <source>Nobody answers. Check wires (A and B may be swapped) and supply.</source>
        <translation>Niemand antwortet. Prüfen Sie Adern (A und B können vertauscht sein) und Versorgung.</translation>
    </message>
    <message>
        <source>Asks the Modbus unit %1 for a register.</source>
        <translation>Fragt die Modbus-Unit %1 nach einem Register.</translation>
    </message>
    <message>
        <source>A Modbus RTU master works on this line.</source>
        <translation>An dieser Leitung arbeitet ein Modbus-RTU-Master.</translation>
    </message>
    <message>
        <source>Modbus/TCP: the host is connected, and the units 1, 247, 255, 0, 2, 3 and 4 are each asked for one input register, or else for one holding register.</source>
        <translation>Modbus/TCP: Eine Verbindung zum Host wird aufgebaut, und die Units 1, 247, 255, 0, 2, 3 und 4 werden je nach einem Input-Register gefragt, sonst nach einem Holding-Register.</translation>
    </message>
    <message>
        <source>The Modbus unit %1 answers too: the host does not look at the unit.</source>
        <translation>Auch die Modbus-Unit %1 antwortet: Der Host achtet nicht auf die Unit.</translation>
    </message>
    <message>
        <source>The search was cancelled.</source>
        <translation>Suche abgebrochen.</translation>
    </message>
    <message>
        <source>Modbus RTU: at 9600 to 115200 Bd with even or no parity, the units 1 to 8 are each asked for one input register, or else for one holding register; whoever answers is asked once more.</source>
        <translation>Modbus RTU: Mit 9600 bis 115200 Bd, gerader oder keiner Parität, werden die Units 1 bis 8 je nach einem Input-Register gefragt, sonst nach einem Holding-Register; wer antwortet, wird noch einmal gefragt.</translation>
    </message>
    <message>
        <source>Bytes came at %1, but none that make sense. Check format, wires (A and B may be swapped) and termination, and whether two encoders have the same address.</source>
        <translation>Bei %1 kamen Bytes, die keinen Sinn ergeben. Prüfen Sie Format, Adern (A und B können vertauscht sein) und Abschluss, und ob zwei Geber dieselbe Adresse haben.</translation>
    </message>
    <message>
        <source>A master began to send while we asked: stopped. Nothing more is sent on this port.</source>
        <translation>Während der Abfrage begann ein Master zu senden: abgebrochen. An diesem Anschluss wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>Listening at %1. Nothing is sent.</source>
        <translation>Horcht mit %1. Nichts wird gesendet.</translation>
    </message>
    <message>
        <source>Bytes come, but none that make sense at %1. Nothing is sent; other settings are tried by listening.</source>
        <translation>Es kommen Bytes, die bei %1 keinen Sinn ergeben. Nichts wird gesendet; es wird mit anderen Einstellungen gehorcht.</translation>
    </message>
    <message>
        <source>Nobody sends on this line by itself.</source>
        <translation>Von selbst sendet auf dieser Leitung niemand.</translation>
    </message>
</context>
<context>
    <name>codewheel::FinderNewsModel</name>
    <message>
        <source>Where</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>How sure</source>
        <translation>Wie sicher</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>codewheel::FolderRows</name>
    <message>
        <source>Open folder: %1</source>
        <translation>Ordner öffnen: %1</translation>
    </message>
    <message>
        <source>Opens the folder in the file manager</source>
        <translation>Öffnet den Ordner in der Dateiverwaltung</translation>
    </message>
    <message>
        <source>Copy path: %1</source>
        <translation>Pfad kopieren: %1</translation>
    </message>
    <message>
        <source>Copies the path</source>
        <translation>Kopiert den Pfad</translation>
    </message>
</context>
<context>
    <name>codewheel::FoundEncoderModel</name>
    <message>
        <source>unknown, answers to 00</source>
        <translation>unbekannt, antwortet auf 00</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Device code</source>
        <translation>Gerätecode</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
</context>
<context>
    <name>codewheel::GatewayForm</name>
    <message>
        <source>Modbus/TCP gateway</source>
        <translation>Modbus/TCP-Gateway</translation>
    </message>
    <message>
        <source>Modbus RTU gateway</source>
        <translation>Modbus-RTU-Gateway</translation>
    </message>
    <message>
        <source>A bus coupler or controller that shows the words of the ring as Modbus registers. It cannot say which devices there are: the bus structure of the project does.</source>
        <translation>Ein Buskoppler oder eine Steuerung, die die Worte des Rings als Modbus-Register zeigt. Welche Teilnehmer es gibt, sagt nicht das Gateway, sondern der Busaufbau des Projekts.</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>The name or address of the gateway in the network, such as 192.168.0.5</source>
        <translation>Name oder Adresse des Gateways im Netz, etwa 192.168.0.5</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>502 with nearly every gateway</source>
        <translation>502 bei fast jedem Gateway</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>Registerplan</translation>
    </message>
    <message>
        <source>Sets the registers below as they are with usual gateways</source>
        <translation>Stellt die Register darunter so ein, wie sie bei üblichen Gateways sind</translation>
    </message>
    <message>
        <source>Register m&amp;ap</source>
        <translation>Registerp&amp;lan</translation>
    </message>
    <message>
        <source>As set below</source>
        <translation>Wie unten eingestellt</translation>
    </message>
    <message>
        <source>Enter the name or address of the gateway.</source>
        <translation>Name oder Adresse des Gateways eingeben.</translation>
    </message>
    <message>
        <source>Choose a serial port, or type the path of one.</source>
        <translation>Einen seriellen Anschluss wählen oder den Pfad eintippen.</translation>
    </message>
    <message>
        <source>As used last: %1</source>
        <translation>Wie zuletzt benutzt: %1</translation>
    </message>
    <message>
        <source>The settings below are those of no usual gateway.</source>
        <translation>Die Einstellungen darunter sind die keines üblichen Gateways.</translation>
    </message>
    <message>
        <source>Serial &amp;port</source>
        <translation>An&amp;schluss</translation>
    </message>
    <message>
        <source>Ho&amp;st</source>
        <translation>Ho&amp;st</translation>
    </message>
</context>
<context>
    <name>codewheel::GatewayPanel</name>
    <message>
        <source>Gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>Figures of the link</source>
        <translation>Zahlen der Verbindung</translation>
    </message>
    <message>
        <source>Since the bus was connected. A transaction is a request with its answer; the median is that of the newest 1000</source>
        <translation>Seit der Bus verbunden wurde. Eine Transaktion ist eine Anfrage mit ihrer Antwort; der Median ist der der letzten 1000</translation>
    </message>
    <message>
        <source>Where it is reached</source>
        <translation>Wo es erreicht wird</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>In Watch only reads are sent</source>
        <translation>In Beobachten wird nur gelesen</translation>
    </message>
    <message>
        <source>Status register</source>
        <translation>Statusregister</translation>
    </message>
    <message>
        <source>As the gateway tells it, if it has one</source>
        <translation>Wie das Gateway es meldet, falls es eines hat</translation>
    </message>
    <message>
        <source>Connection…</source>
        <translation>Verbindung…</translation>
    </message>
    <message>
        <source>Kind of link, host or port, and the registers of the gateway</source>
        <translation>Art der Verbindung, Host oder Anschluss und die Register des Gateways</translation>
    </message>
    <message>
        <source>Registers…</source>
        <translation>Register…</translation>
    </message>
    <message>
        <source>The registers of each device, and the word order</source>
        <translation>Die Register jedes Teilnehmers und die Wortreihenfolge</translation>
    </message>
    <message>
        <source>Connected, stopped</source>
        <translation>Verbunden, angehalten</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Verbindet</translation>
    </message>
    <message>
        <source>Link lost; it is tried again each second</source>
        <translation>Verbindung weg; jede Sekunde ein neuer Versuch</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Operate: OUT is written</source>
        <translation>Bedienen: OUT wird geschrieben</translation>
    </message>
    <message>
        <source>Watch: only reads are sent</source>
        <translation>Beobachten: Es wird nur gelesen</translation>
    </message>
    <message>
        <source>Connected; whether the ring runs is not told</source>
        <translation>Verbunden; ob der Ring läuft, wird nicht gesagt</translation>
    </message>
    <message>
        <source>Connected, and the ring runs</source>
        <translation>Verbunden, und der Ring läuft</translation>
    </message>
    <message>
        <source>Connected, but the ring has failed</source>
        <translation>Verbunden, aber der Ring ist ausgefallen</translation>
    </message>
    <message>
        <source>Connected, but the ring stands still</source>
        <translation>Verbunden, aber der Ring steht</translation>
    </message>
    <message>
        <source>Connected, but its outputs are blocked</source>
        <translation>Verbunden, aber seine Ausgänge sind gesperrt</translation>
    </message>
    <message>
        <source>The zeros of the ALARM STOP are sent until they arrive</source>
        <translation>Die Nullen des ALARM-STOPPs werden gesendet, bis sie ankommen</translation>
    </message>
</context>
<context>
    <name>codewheel::GatewayPreset</name>
    <message>
        <source>High word first</source>
        <translation>Oberes Wort zuerst</translation>
    </message>
    <message>
        <source>IN in input registers, OUT in holding registers, both from 0</source>
        <translation>IN in Input-Registern, OUT in Holding-Registern, beide ab 0</translation>
    </message>
    <message>
        <source>Low word first</source>
        <translation>Unteres Wort zuerst</translation>
    </message>
    <message>
        <source>The same, but the first register of each encoder is the low half of its word</source>
        <translation>Ebenso, aber das erste Register jedes Gebers ist die untere Hälfte seines Wortes</translation>
    </message>
    <message>
        <source>Holding registers only</source>
        <translation>Nur Holding-Register</translation>
    </message>
    <message>
        <source>IN from 0 and OUT from 512, read by function 3 and written by function 16</source>
        <translation>IN ab 0 und OUT ab 512, mit Funktion 3 gelesen und mit Funktion 16 geschrieben</translation>
    </message>
    <message>
        <source>Holding registers, function 23</source>
        <translation>Holding-Register, Funktion 23</translation>
    </message>
    <message>
        <source>The same, but OUT is written and IN is read in one transaction</source>
        <translation>Ebenso, aber OUT wird in derselben Transaktion geschrieben, in der IN gelesen wird</translation>
    </message>
    <message>
        <source>A training bus of Codewheel</source>
        <translation>Ein Übungsbus von Codewheel</translation>
    </message>
    <message>
        <source>As another Codewheel offers its training bus; the state of the ring is in register 8192</source>
        <translation>So bietet ein anderes Codewheel seinen Übungsbus an; der Zustand des Rings steht in Register 8192</translation>
    </message>
</context>
<context>
    <name>codewheel::GatewayTexts</name>
    <message>
        <source>Not tested, because of what failed before.</source>
        <translation>Nicht geprüft, weil etwas davor fehlgeschlagen ist.</translation>
    </message>
    <message>
        <source>Connected with %1.</source>
        <translation>Verbunden mit %1.</translation>
    </message>
    <message>
        <source>No device of the project has IN words.</source>
        <translation>Kein Teilnehmer des Projekts hat IN-Worte.</translation>
    </message>
    <message>
        <source>No device of the project has OUT words.</source>
        <translation>Kein Teilnehmer des Projekts hat OUT-Worte.</translation>
    </message>
    <message>
        <source>OUT is not read back, as the settings say, so nothing tells whether its registers are there or who writes them.</source>
        <translation>OUT wird laut Einstellung nicht zurückgelesen; ob es seine Register gibt und wer sie schreibt, ist also unbekannt.</translation>
    </message>
    <message>
        <source>The status register is %1.</source>
        <translation>Das Statusregister ist %1.</translation>
    </message>
    <message>
        <source>high word first</source>
        <translation>oberes Wort zuerst</translation>
    </message>
    <message>
        <source>low word first</source>
        <translation>unteres Wort zuerst</translation>
    </message>
    <message>
        <source>It can with %1 (%2): change the word order.</source>
        <translation>Er kann es bei „%1“ (%2): Die Wortreihenfolge ändern.</translation>
    </message>
    <message>
        <source>It can with the bytes of each register exchanged: set the gateway so that it does not exchange them.</source>
        <translation>Mit vertauschten Bytes in jedem Register kann er es: Das Gateway so einstellen, dass es sie nicht vertauscht.</translation>
    </message>
    <message>
        <source>It can in no order. Check that its IN words begin at register %1.</source>
        <translation>In keiner Reihenfolge kann er es. Prüfen, ob seine IN-Worte bei Register %1 beginnen.</translation>
    </message>
    <message>
        <source>It is the same in both word orders. Test again with another position.</source>
        <translation>Es ist in beiden Wortreihenfolgen gleich. An einer anderen Position noch einmal testen.</translation>
    </message>
    <message>
        <source>With %1 it can be %2 as well. Test again with another position.</source>
        <translation>Bei „%1“ kann es ebenso %2 sein. An einer anderen Position noch einmal testen.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Serieller Anschluss</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unit</translation>
    </message>
    <message>
        <source>IN registers</source>
        <translation>IN-Register</translation>
    </message>
    <message>
        <source>OUT registers</source>
        <translation>OUT-Register</translation>
    </message>
    <message>
        <source>Status register</source>
        <translation>Statusregister</translation>
    </message>
    <message>
        <source>Word of %1</source>
        <translation>Wort von %1</translation>
    </message>
    <message>
        <source>The host %1 is known.</source>
        <translation>Der Host %1 ist bekannt.</translation>
    </message>
    <message>
        <source>The port %1 is there.</source>
        <translation>Der Anschluss %1 ist da.</translation>
    </message>
    <message>
        <source>Unit %1 answers after %2 ms.</source>
        <translation>Unit %1 antwortet nach %2 ms.</translation>
    </message>
    <message>
        <source>All registers of the project can be read (%1).</source>
        <translation>Alle Register des Projekts lassen sich lesen (%1).</translation>
    </message>
    <message>
        <source>What can be read ends before the registers of %1, which begin at %2.</source>
        <translation>Was sich lesen lässt, endet vor den Registern von %1, die bei %2 beginnen.</translation>
    </message>
    <message>
        <source>It has no IN word.</source>
        <translation>Er hat kein IN-Wort.</translation>
    </message>
    <message>
        <source>IN is %1: %2.</source>
        <translation>IN ist %1: %2.</translation>
    </message>
    <message>
        <source>IN is %1, which is beyond the total range of the encoder.</source>
        <translation>IN ist %1, das liegt außerhalb des Gesamtbereichs des Gebers.</translation>
    </message>
    <message>
        <source>IN is %1, which this encoder never sends.</source>
        <translation>IN ist %1, das sendet dieser Geber nie.</translation>
    </message>
    <message>
        <source>IN is %1. What this device sends is not described.</source>
        <translation>IN ist %1. Was dieses Gerät sendet, ist nicht beschrieben.</translation>
    </message>
    <message>
        <source>the encoder can send this</source>
        <translation>kann der Geber senden</translation>
    </message>
    <message>
        <source>beyond its total range</source>
        <translation>außerhalb seines Gesamtbereichs</translation>
    </message>
    <message>
        <source>the encoder never sends this</source>
        <translation>sendet der Geber nie</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>The image of this ring would end behind register 65535.</source>
        <translation>Das Abbild dieses Rings würde hinter Register 65535 enden.</translation>
    </message>
    <message>
        <source>Function 23 reads holding registers only, and IN is in input registers.</source>
        <translation>Funktion 23 liest nur Holding-Register, und IN steht in Input-Registern.</translation>
    </message>
    <message>
        <source>IN (registers %1 to %2) and OUT (%3 to %4) overlap.</source>
        <translation>IN (Register %1 bis %2) und OUT (%3 bis %4) überschneiden sich.</translation>
    </message>
    <message>
        <source>The control register %1 is within the image.</source>
        <translation>Das Steuerregister %1 liegt im Abbild.</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 (ms)</source>
        <translation>%1 (ms)</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1, oder %2</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>Unit %1</translation>
    </message>
    <message>
        <source>function %1, register %2</source>
        <translation>Funktion %1, Register %2</translation>
    </message>
    <message>
        <source>function %1, registers %2 to %3</source>
        <translation>Funktion %1, Register %2 bis %3</translation>
    </message>
    <message>
        <source>it does not have this function.</source>
        <translation>Diese Funktion gibt es dort nicht.</translation>
    </message>
    <message>
        <source>it does not have these registers. Its image is shorter, or begins elsewhere.</source>
        <translation>Diese Register gibt es dort nicht. Das Abbild ist kürzer oder beginnt woanders.</translation>
    </message>
    <message>
        <source>it does not accept this value or this number of registers.</source>
        <translation>Dieser Wert oder diese Zahl von Registern wird dort nicht angenommen.</translation>
    </message>
    <message>
        <source>it failed while carrying this out.</source>
        <translation>Beim Ausführen ist dort ein Fehler aufgetreten.</translation>
    </message>
    <message>
        <source>it has accepted the request and needs longer for it.</source>
        <translation>Die Anfrage ist dort angenommen und braucht länger.</translation>
    </message>
    <message>
        <source>it is busy.</source>
        <translation>Es ist beschäftigt.</translation>
    </message>
    <message>
        <source>its memory is damaged.</source>
        <translation>Der Speicher dort ist beschädigt.</translation>
    </message>
    <message>
        <source>the gateway has no path to the unit. Check the unit number.</source>
        <translation>Das Gateway hat keinen Weg zur Unit. Die Unit-Nummer prüfen.</translation>
    </message>
    <message>
        <source>the unit behind the gateway does not answer.</source>
        <translation>Die Unit hinter dem Gateway antwortet nicht.</translation>
    </message>
    <message>
        <source>this code is not in the standard.</source>
        <translation>Diesen Code kennt die Norm nicht.</translation>
    </message>
    <message>
        <source>Word order</source>
        <translation>Wortreihenfolge</translation>
    </message>
    <message>
        <source>no IN word</source>
        <translation>kein IN-Wort</translation>
    </message>
    <message>
        <source>bits from 0 to 15, as %1, or %2</source>
        <translation>Bits von 0 bis 15, wie %1, oder %2</translation>
    </message>
    <message>
        <source>What its bits mean is not set, so nothing tells whether the ring runs.</source>
        <translation>Was seine Bits bedeuten, ist nicht eingestellt; daher sagt nichts, ob der Ring läuft.</translation>
    </message>
    <message>
        <source>The ring runs.</source>
        <translation>Der Ring läuft.</translation>
    </message>
    <message>
        <source>They are those of a ring that Codewheel offers; its status register tells whether it runs.</source>
        <translation>Es sind die eines Rings, den Codewheel anbietet; sein Statusregister sagt, ob er läuft.</translation>
    </message>
    <message>
        <source>It can with %1 (%2).</source>
        <translation>Mit „%1“ kann er es (%2).</translation>
    </message>
    <message>
        <source>IN from register %1, %2</source>
        <translation>IN ab Register %1, %2</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>Registerplan</translation>
    </message>
    <message>
        <source>No word of this ring can be judged.</source>
        <translation>Kein Wort dieses Rings lässt sich beurteilen.</translation>
    </message>
    <message>
        <source>The words fit no map near this one (%1). Check the first register of IN, and the bus structure.</source>
        <translation>Die Worte passen zu keinem Registerplan in der Nähe von diesem (%1). Prüfen Sie das erste Register von IN und den Busaufbau.</translation>
    </message>
    <message>
        <source>The words fit this map, but also: %1. Test again with other positions, of a shaft that was turned by 65536 steps, before you write.</source>
        <translation>Die Worte passen zu diesem Registerplan, aber auch zu: %1. Testen Sie noch einmal mit anderen Positionen, nachdem eine Welle um 65536 Schritte gedreht wurde, bevor Sie schreiben.</translation>
    </message>
    <message>
        <source>The words do not fit this map, but this one: %1.</source>
        <translation>Die Worte passen nicht zu diesem Registerplan, aber zu: %1.</translation>
    </message>
    <message>
        <source>The words do not fit this map, but several others: %1. Test again with other positions, or look into the manual of the gateway.</source>
        <translation>Die Worte passen nicht zu diesem Registerplan, aber zu mehreren anderen: %1. Testen Sie noch einmal mit anderen Positionen oder sehen Sie im Handbuch des Gateways nach.</translation>
    </message>
    <message>
        <source>The watchdog register %1 is within the image.</source>
        <translation>Das Watchdog-Register %1 liegt im Abbild.</translation>
    </message>
    <message>
        <source>All registers can be read, but no more than %1 in one request: set that many in a read. How many it takes in a write is not tested, since the test writes nothing.</source>
        <translation>Alle Register lassen sich lesen, aber nicht mehr als %1 in einer Anfrage: Stellen Sie so viele je Lesen ein. Wie viele es je Schreiben annimmt, wird nicht getestet, da der Test nichts schreibt.</translation>
    </message>
    <message>
        <source>0 is no exception code: its answer is faulty.</source>
        <translation>0 ist kein Exception-Code: Die Antwort ist fehlerhaft.</translation>
    </message>
    <message>
        <source>it does not accept so many registers at once, or not these values. Set fewer registers in a write, in the connection.</source>
        <translation>Es nimmt nicht so viele Register auf einmal an oder diese Werte nicht. Stellen Sie in der Verbindung weniger Register je Schreiben ein.</translation>
    </message>
    <message>
        <source>The words of IN fit this map, and none near it. Where OUT begins shows nowhere: compare it with the manual of the gateway.</source>
        <translation>Die Worte von IN passen zu diesem Registerplan und zu keinem daneben. Wo OUT beginnt, zeigt sich nirgends: Vergleichen Sie es mit dem Handbuch des Gateways.</translation>
    </message>
    <message>
        <source>The register of the place is the status register, %1.</source>
        <translation>Das Register des Ortes ist das Statusregister, %1.</translation>
    </message>
    <message>
        <source>register %1</source>
        <comment>the first of a device</comment>
        <translation>Register %1</translation>
    </message>
    <message>
        <source>it is incomplete. Look for newer firmware of the gateway.</source>
        <translation>sie ist unvollständig. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>it is damaged or incomplete. Check cable, shield, terminating resistors, baud rate, and format.</source>
        <translation>sie ist beschädigt oder unvollständig. Kabel, Schirm, Abschlusswiderstände, Baudrate und Format prüfen.</translation>
    </message>
    <message>
        <source>it is not Modbus. Check the port: something else listens there.</source>
        <translation>sie ist kein Modbus. Den Port prüfen: Dort läuft etwas anderes.</translation>
    </message>
    <message>
        <source>it is of unit %1. Check the unit number, and on a serial line whether two devices have the same.</source>
        <translation>sie kommt von Unit %1. Die Unit-Nummer prüfen, und an einer seriellen Leitung, ob zwei Geräte dieselbe haben.</translation>
    </message>
    <message>
        <source>it is for transaction %1, not %2. Look for newer firmware of the gateway.</source>
        <translation>sie gehört zu Transaktion %1, nicht %2. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>each is for transaction %1: the gateway does not repeat the number of the request, as Modbus/TCP wants it. Use Modbus RTU, if it has that, or look for newer firmware.</source>
        <translation>jede ist für Transaktion %1: Das Gateway wiederholt nicht die Nummer der Anfrage, wie Modbus/TCP es will. Modbus RTU nehmen, falls vorhanden, oder nach neuerer Firmware suchen.</translation>
    </message>
    <message>
        <source>it is for function %1. Look for newer firmware of the gateway.</source>
        <translation>sie gehört zu Funktion %1. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>it has %1 bytes instead of %2. Compare the number of registers with the manual of the gateway, or look for newer firmware.</source>
        <translation>sie hat %1 Bytes statt %2. Die Zahl der Register mit dem Handbuch des Gateways vergleichen oder nach neuerer Firmware suchen.</translation>
    </message>
    <message>
        <source>it names other registers than those to be written. Look for newer firmware of the gateway.</source>
        <translation>sie nennt andere Register, als geschrieben werden sollten. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>it counts its own bytes wrong. Look for newer firmware of the gateway.</source>
        <translation>sie zählt ihre eigenen Bytes falsch. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>it is an exception of the wrong length. Look for newer firmware of the gateway.</source>
        <translation>sie ist eine Exception mit falscher Länge. Nach neuerer Firmware des Gateways suchen.</translation>
    </message>
    <message>
        <source>another one follows it. Check whether two devices on the line have the same unit number.</source>
        <translation>ihr folgt noch eine. Prüfen, ob zwei Geräte an der Leitung dieselbe Unit-Nummer haben.</translation>
    </message>
    <message>
        <source>something on the line does not stop sending. Look for another master, or a faulty device.</source>
        <translation>etwas an der Leitung hört nicht auf zu senden. Nach einem anderen Master oder einem defekten Gerät suchen.</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>The gateway closes the connection after each answer: this test took %1 of them. Nothing is lost, but each exchange takes longer.</source>
        <translation>Das Gateway schließt die Verbindung nach jeder Antwort: Dieser Test brauchte %1 davon. Verloren geht nichts, aber jeder Austausch dauert länger.</translation>
    </message>
</context>
<context>
    <name>codewheel::GearPanel</name>
    <message>
        <source>Travel per turn of the driven part</source>
        <translation>Weg je Umdrehung des angetriebenen Teils</translation>
    </message>
    <message>
        <source>mm the machine moves in one turn of its spindle, wheel or drum.</source>
        <translation>Weg der Maschine in mm bei einer Umdrehung von Spindel, Rad oder Trommel.</translation>
    </message>
    <message>
        <source>Encoder turns of the gear</source>
        <translation>Getriebe: Umdrehungen des Gebers</translation>
    </message>
    <message>
        <source>Part turns of the gear</source>
        <translation>Getriebe: Umdrehungen der Last</translation>
    </message>
    <message>
        <source>Wanted resolution</source>
        <translation>Gewünschte Auflösung</translation>
    </message>
    <message>
        <source>mm for one step of the position.</source>
        <translation>mm für einen Schritt der Position.</translation>
    </message>
    <message>
        <source>&amp;Use these</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;mm per turn</source>
        <translation>&amp;mm je Umdrehung</translation>
    </message>
    <message>
        <source>mm per s&amp;tep</source>
        <translation>mm je Schr&amp;itt</translation>
    </message>
    <message>
        <source>&amp;Gear ratio encoder</source>
        <translation>Get&amp;riebe Geber</translation>
    </message>
    <message>
        <source>to &amp;load</source>
        <translation>zu &amp;Last</translation>
    </message>
    <message>
        <source>The encoder cannot resolve this. Choose more mm per step.</source>
        <translation>So fein löst der Geber nicht auf. Mehr mm je Schritt wählen.</translation>
    </message>
    <message>
        <source>%1 steps in %2 %6: %3 mm per step, %4 mm off over %5 mm.</source>
        <translation>%1 Schritte bei %2 %6: %3 mm je Schritt, %4 mm Abweichung auf %5 mm.</translation>
    </message>
    <message>
        <source>From mm and gear</source>
        <translation>Von mm und Getriebe</translation>
    </message>
    <message>
        <source>Turns of the encoder …</source>
        <translation>Umdrehungen des Gebers …</translation>
    </message>
    <message>
        <source>… while the driven part makes so many turns.</source>
        <translation>… bei so vielen Umdrehungen des angetriebenen Teils.</translation>
    </message>
    <message>
        <source>Adds these steps and revolutions to the wanted values.</source>
        <translation>Übernimmt diese Schritte und Umdrehungen in die gewünschten Werte.</translation>
    </message>
</context>
<context>
    <name>codewheel::GoToPlace</name>
    <message>
        <source>Choose in the bus structure what the row is about (Ctrl+G)</source>
        <translation>Im Busaufbau wählen, worum es in der Zeile geht (Strg+G)</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <comment>a device or a bus</comment>
        <translation>Gehe zu %1</translation>
    </message>
    <message>
        <source>Go to the device</source>
        <translation>Gehe zum Gerät</translation>
    </message>
</context>
<context>
    <name>codewheel::HandWheel</name>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Turn the shaft by hand: drag, or use the arrow keys and Page Up, Page Down</source>
        <translation>Die Welle von Hand drehen: ziehen, oder Pfeiltasten und Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Umdr.</translation>
    </message>
    <message>
        <source>1 step counter-clockwise</source>
        <translation>1 Schritt gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>1 step clockwise</source>
        <translation>1 Schritt im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>A quarter turn counter-clockwise</source>
        <translation>Eine Viertelumdrehung gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>A quarter turn clockwise</source>
        <translation>Eine Viertelumdrehung im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>1 turn counter-clockwise</source>
        <translation>1 Umdrehung gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>1 turn clockwise</source>
        <translation>1 Umdrehung im Uhrzeigersinn</translation>
    </message>
</context>
<context>
    <name>codewheel::HandshakePage</name>
    <message>
        <source>Handshake</source>
        <translation>Handshake</translation>
    </message>
    <message>
        <source>Next &amp;step</source>
        <translation>Nächster &amp;Schritt</translation>
    </message>
    <message>
        <source>Run b&amp;y itself</source>
        <translation>Auto&amp;matisch</translation>
    </message>
    <message>
        <source>R&amp;un with what it has</source>
        <translation>R&amp;un mit dem jetzigen Stand</translation>
    </message>
    <message>
        <source>Steps of the handshake</source>
        <translation>Schritte des Handshakes</translation>
    </message>
    <message>
        <source>Sends run: what the encoder has taken becomes valid, if it accepts it.</source>
        <translation>Sendet Run: Was der Geber übernommen hat, wird gültig, wenn er es annimmt.</translation>
    </message>
    <message>
        <source>Begins</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>OUT %1  %2</source>
        <translation>OUT %1  %2</translation>
    </message>
    <message>
        <source>IN  %1  %2</source>
        <translation>IN  %1  %2</translation>
    </message>
    <message>
        <source>Brought back</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Verified: %1. %2</source>
        <translation>Geprüft: %1. %2</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Stopped by an error</source>
        <translation>Durch Fehler angehalten</translation>
    </message>
    <message>
        <source>about </source>
        <translation>etwa </translation>
    </message>
    <message>
        <source>What the position will then read is not known.</source>
        <translation>Was die Position dann zeigt, ist nicht bestimmbar.</translation>
    </message>
    <message>
        <source>Brings the encoder back</source>
        <translation>Stellt den Geber zurück</translation>
    </message>
    <message>
        <source>&amp;Report</source>
        <translation>Be&amp;richt</translation>
    </message>
    <message>
        <source>&amp;End the service</source>
        <translation>Den Dienst bee&amp;nden</translation>
    </message>
    <message>
        <source>Takes the service bit back: the encoder shows its position again.</source>
        <translation>Nimmt das Dienst-Bit zurück: Der Geber zeigt wieder seine Position.</translation>
    </message>
    <message>
        <source>Sends the next step.</source>
        <translation>Sendet den nächsten Schritt.</translation>
    </message>
    <message>
        <source>The remaining steps follow each other as the encoder confirms them.</source>
        <translation>Die übrigen Schritte laufen nacheinander ab, sobald der Geber quittiert.</translation>
    </message>
    <message>
        <source>Rest&amp;ore earlier values</source>
        <translation>&amp;Vorige Werte wiederherstellen</translation>
    </message>
    <message>
        <source>Writes the earlier values again.</source>
        <translation>Schreibt die vorigen Werte wieder.</translation>
    </message>
    <message>
        <source>If the shaft has not moved since the encoder last showed its position, it will then read %1%2.</source>
        <comment>&apos;about &apos; or nothing, position</comment>
        <translation>Wenn sich die Welle nicht bewegt hat, seit der Geber zuletzt seine Position zeigte, ist sie dann %1%2.</translation>
    </message>
</context>
<context>
    <name>codewheel::HelpBrowser</name>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
</context>
<context>
    <name>codewheel::HelpSidebar</name>
    <message>
        <source>Search the manual</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Searches all pages for sections that have all these words (Ctrl+Shift+F)</source>
        <translation>Sucht auf allen Seiten nach Abschnitten, die alle diese Wörter enthalten (Strg+Umschalt+F)</translation>
    </message>
    <message>
        <source>Sections found</source>
        <translation>Gefundene Abschnitte</translation>
    </message>
    <message>
        <source>Sections of the manual that have all words searched for</source>
        <translation>Abschnitte des Handbuchs, die alle gesuchten Wörter enthalten</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Pages of the manual and their sections</source>
        <translation>Seiten des Handbuchs und ihre Abschnitte</translation>
    </message>
    <message>
        <source>Files and protocols</source>
        <translation>Dateien und Protokolle</translation>
    </message>
    <message>
        <source>No section of the manual has all these words.</source>
        <translation>Kein Abschnitt des Handbuchs enthält alle diese Wörter.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n Abschnitt</numerusform>
            <numerusform>%n Abschnitte</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the page before</source>
        <translation>Zur Seite davor</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Erste Seite</translation>
    </message>
    <message>
        <source>To the first page of the manual</source>
        <translation>Zur ersten Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Searches all pages</source>
        <translation>Durchsucht alle Seiten</translation>
    </message>
    <message>
        <source>Find in this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Marks a text on this page</source>
        <translation>Markiert einen Text auf dieser Seite</translation>
    </message>
    <message>
        <source>The manual is not there: %1 is missing. It comes with the program; build or install the program again.</source>
        <translation>Das Handbuch ist nicht da: %1 fehlt. Es gehört zum Programm; das Programm neu bauen oder installieren.</translation>
    </message>
    <message>
        <source>To the page you came back from</source>
        <translation>Zur Seite, die mit Zurück verlassen wurde</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Nächste Stelle</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Vorige Stelle</translation>
    </message>
</context>
<context>
    <name>codewheel::InlineMessage</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>role: sentence</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Copies it, for pasting it into a terminal: %1</source>
        <translation>Kopiert ihn, um ihn in ein Terminal einzufügen: %1</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
</context>
<context>
    <name>codewheel::InsertPanel</name>
    <message>
        <source>&amp;Insert device</source>
        <translation>Gerät ein&amp;fügen</translation>
    </message>
    <message>
        <source>Chan&amp;ge to it</source>
        <translation>Dadurch ersetze&amp;n</translation>
    </message>
    <message>
        <source>Search the catalog: maker, name, profile or ID code</source>
        <translation>Katalog durchsuchen: Hersteller, Name, Profil oder ID-Code</translation>
    </message>
    <message>
        <source>Search the catalog</source>
        <translation>Katalog durchsuchen</translation>
    </message>
    <message>
        <source>Devices of the catalog</source>
        <translation>Geräte des Katalogs</translation>
    </message>
    <message>
        <source>Enter or a double click inserts the device</source>
        <translation>Eingabetaste oder Doppelklick fügt das Gerät ein</translation>
    </message>
    <message>
        <source>ID code</source>
        <translation>ID-Code</translation>
    </message>
    <message>
        <source>The low byte of the device code, hexadecimal: kind and direction</source>
        <translation>Das niederwertige Byte des Gerätecodes, hexadezimal: Art und Richtung</translation>
    </message>
    <message>
        <source>Length code</source>
        <translation>Längencode</translation>
    </message>
    <message>
        <source>The high byte of the device code, hexadecimal: data width</source>
        <translation>Das höherwertige Byte des Gerätecodes, hexadezimal: Datenbreite</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Inserts the device at this place</source>
        <translation>Fügt das Gerät an diesem Platz ein</translation>
    </message>
    <message>
        <source>Makes the chosen device of the bus one of these; station, group and addresses stay</source>
        <translation>Macht aus dem gewählten Teilnehmer ein solches Gerät; Station, Gruppe und Adressen bleiben</translation>
    </message>
    <message>
        <source>&amp;Length code</source>
        <translation>&amp;Längencode</translation>
    </message>
    <message>
        <source>C&amp;atalog</source>
        <translation>Ka&amp;talog</translation>
    </message>
    <message>
        <source>I&amp;D code</source>
        <translation>ID-&amp;Code</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Platz</translation>
    </message>
    <message>
        <source>Codes are two hexadecimal digits, such as BEh and 81h.</source>
        <translation>Codes haben zwei Hexziffern, etwa BEh und 81h.</translation>
    </message>
    <message>
        <source>Close the insert panel</source>
        <translation>Einfügebereich schließen</translation>
    </message>
    <message>
        <source>Closes this panel (Esc)</source>
        <translation>Schließt diesen Bereich (Esc)</translation>
    </message>
    <message>
        <source>Search the catalog: maker or name</source>
        <translation>Katalog durchsuchen: Hersteller oder Name</translation>
    </message>
    <message>
        <source>Every place of this bus is taken.</source>
        <translation>Jeder Platz an diesem Bus ist belegt.</translation>
    </message>
    <message>
        <source>Where the device is inserted, relative to the chosen one</source>
        <translation>Wo das Gerät eingefügt wird, vom gewählten aus gesehen</translation>
    </message>
    <message>
        <source>Shows the devices of the catalog that have these words</source>
        <translation>Zeigt die Geräte des Katalogs, in denen diese Wörter vorkommen</translation>
    </message>
</context>
<context>
    <name>codewheel::JobReview</name>
    <message>
        <source>The manual states about %1 writes for the encoder&apos;s life.</source>
        <translation>Das Handbuch nennt etwa %1 Schreibvorgänge für die Lebensdauer des Gebers.</translation>
    </message>
    <message>
        <source>Write &amp;all, including what is there</source>
        <translation>A&amp;lles schreiben, auch Vorhandenes</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Writes everything that is wanted once more. That costs EEPROM writes.</source>
        <translation>Schreibt alles Gewünschte noch einmal. Das kostet EEPROM-Schreibvorgänge.</translation>
    </message>
    <message>
        <source>Write what is shown</source>
        <translation>Schreiben, was hier steht</translation>
    </message>
    <message>
        <source>Back; nothing is sent (Esc)</source>
        <translation>Zurück; gesendet wird nichts (Esc)</translation>
    </message>
    <message>
        <source>EEPROM writes by this: at most %1.</source>
        <translation>EEPROM-Schreibvorgänge hierdurch: höchstens %1.</translation>
    </message>
    <message>
        <source>Agree to that first, at the end of the list.</source>
        <translation>Zuerst am Ende der Liste zustimmen.</translation>
    </message>
    <message>
        <source>Writes everything that is wanted once more. That costs no EEPROM write.</source>
        <translation>Schreibt alles Gewünschte noch einmal. Das kostet keinen EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>Writes everything that is wanted once more.</source>
        <translation>Schreibt alles Gewünschte noch einmal.</translation>
    </message>
</context>
<context>
    <name>codewheel::JobStrip</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Progress of the job</source>
        <translation>Fortschritt des Auftrags</translation>
    </message>
    <message>
        <source>The job begins.</source>
        <translation>Der Auftrag beginnt.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Encoders done</source>
        <translation>Erledigte Geber</translation>
    </message>
    <message>
        <source>Encoders done, of all that were chosen</source>
        <translation>Erledigte Geber von allen gewählten</translation>
    </message>
    <message>
        <source>Steps of the running job</source>
        <translation>Schritte des laufenden Auftrags</translation>
    </message>
    <message>
        <source>Encoder %1 of %2: %3.</source>
        <translation>Geber %1 von %2: %3.</translation>
    </message>
    <message>
        <source>Ends the job; asks in which state to leave the encoder</source>
        <translation>Beendet den Auftrag; fragt, in welchem Zustand der Geber bleiben soll</translation>
    </message>
    <message>
        <source>Ends the job, after asking in which state to leave the encoder; the others are not started</source>
        <translation>Beendet den Auftrag, nach der Frage, in welchem Zustand der Geber bleiben soll; die anderen werden nicht begonnen</translation>
    </message>
    <message>
        <source>No other is started.</source>
        <translation>Kein weiterer wird begonnen.</translation>
    </message>
</context>
<context>
    <name>codewheel::Journal</name>
    <message>
        <source>it is damaged, or no database at all.</source>
        <translation>sie ist beschädigt oder gar keine Datenbank.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>it is not writable.</source>
        <translation>sie ist nicht beschreibbar.</translation>
    </message>
    <message>
        <source>its folder cannot be made.</source>
        <translation>ihr Ordner lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is missing on this computer.</source>
        <translation>der Qt-Treiber für SQLite fehlt auf diesem Rechner.</translation>
    </message>
    <message>
        <source>it is the database of another program.</source>
        <translation>sie ist die Datenbank eines anderen Programms.</translation>
    </message>
    <message>
        <source>Message &quot;%1&quot; of another version of Codewheel.</source>
        <translation>Meldung „%1“ einer anderen Version von Codewheel.</translation>
    </message>
    <message>
        <source>Message &quot;%1&quot; of another version of Codewheel: %2</source>
        <translation>Meldung „%1“ einer anderen Version von Codewheel: %2</translation>
    </message>
    <message>
        <source>it is not a file.</source>
        <translation>sie ist keine Datei.</translation>
    </message>
    <message>
        <source>it is not a database, and was left as it was.</source>
        <translation>sie ist keine Datenbank und blieb unverändert.</translation>
    </message>
    <message>
        <source>another program has locked it.</source>
        <translation>ein anderes Programm hat sie gesperrt.</translation>
    </message>
    <message>
        <source>its disk cannot be read or written.</source>
        <translation>ihr Datenträger kann nicht gelesen oder beschrieben werden.</translation>
    </message>
    <message>
        <source>This is not a time such as 2026-03-01T13:00:00.000Z.</source>
        <translation>Das ist keine Zeitangabe der Form 2026-03-01T13:00:00.000Z.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>Zeile %1, %2: %3</translation>
    </message>
    <message>
        <source>These are no EEPROM counts: &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>Das sind keine EEPROM-Zähler: „format“ ist nicht „%1“.</translation>
    </message>
    <message>
        <source>it contains more than fits into memory.</source>
        <translation>sie enthält mehr, als in den Speicher passt.</translation>
    </message>
    <message>
        <source>it was made by a newer Codewheel (version %1 of the file; this one reads up to version %2).</source>
        <translation>sie stammt von einem neueren Codewheel (Dateiversion %1; dieses liest bis %2).</translation>
    </message>
    <message>
        <source>it does not exist.</source>
        <translation>es gibt sie nicht.</translation>
    </message>
    <message>
        <source>it is not readable.</source>
        <translation>sie ist nicht lesbar.</translation>
    </message>
    <message>
        <source>its folder is not there, or you may not use it.</source>
        <translation>ihr Ordner fehlt oder darf nicht benutzt werden.</translation>
    </message>
    <message>
        <source>it is empty: the program that made it ended before anything was in it.</source>
        <translation>sie ist leer: Das Programm, das sie angelegt hat, endete, bevor etwas darin stand.</translation>
    </message>
    <message>
        <source>Only versions 1 to %1 of the format can be read.</source>
        <translation>Nur die Versionen 1 bis %1 des Formats lassen sich lesen.</translation>
    </message>
</context>
<context>
    <name>codewheel::JsonObject</name>
    <message>
        <source>An object { } is expected here.</source>
        <translation>Hier wird ein Objekt { } erwartet.</translation>
    </message>
    <message>
        <source>This key is not known. Known are: %1.</source>
        <translation>Dieser Schlüssel ist unbekannt. Bekannt sind: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here. Known are: %2.</source>
        <translation>„%1“ ist hier unbekannt. Bekannt sind: %2.</translation>
    </message>
    <message>
        <source>This key is missing.</source>
        <translation>Dieser Schlüssel fehlt.</translation>
    </message>
    <message>
        <source>A text in quotation marks is expected here.</source>
        <translation>Hier wird ein Text in Anführungszeichen erwartet.</translation>
    </message>
    <message>
        <source>true or false is expected here.</source>
        <translation>Hier wird true oder false erwartet.</translation>
    </message>
    <message>
        <source>A whole number is expected here.</source>
        <translation>Hier wird eine ganze Zahl erwartet.</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 liegt nicht zwischen %2 und %3.</translation>
    </message>
    <message>
        <source>A hexadecimal number such as &quot;37h&quot; is expected here.</source>
        <translation>Hier wird eine hexadezimale Zahl wie &quot;37h&quot; erwartet.</translation>
    </message>
    <message>
        <source>A list [ ] is expected here.</source>
        <translation>Hier wird eine Liste [ ] erwartet.</translation>
    </message>
    <message>
        <source>A list of texts [&quot;...&quot;] is expected here.</source>
        <translation>Hier wird eine Liste von Texten [&quot;...&quot;] erwartet.</translation>
    </message>
    <message>
        <source>A text in quotation marks or an object {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;} is expected here.</source>
        <translation>Hier wird ein Text in Anführungszeichen oder ein Objekt {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;} erwartet.</translation>
    </message>
    <message>
        <source>An object of texts {&quot;...&quot;: &quot;...&quot;} is expected here.</source>
        <translation>Hier wird ein Objekt aus Texten {&quot;...&quot;: &quot;...&quot;} erwartet.</translation>
    </message>
    <message>
        <source>A number is expected here.</source>
        <translation>Hier wird eine Zahl erwartet.</translation>
    </message>
    <message>
        <source>The list has %1 entries; at most %2 are allowed.</source>
        <translation>Die Liste hat %1 Einträge; erlaubt sind höchstens %2.</translation>
    </message>
    <message>
        <source>A word is a text of up to 8 hexadecimal digits, such as &quot;020000FF&quot;.</source>
        <translation>Ein Wort ist ein Text aus bis zu 8 Hexziffern, etwa &quot;020000FF&quot;.</translation>
    </message>
</context>
<context>
    <name>codewheel::KeySheet</name>
    <message>
        <source>Search the keys</source>
        <translation>Tasten durchsuchen</translation>
    </message>
    <message>
        <source>Leaves the keys that do this, or have this name</source>
        <translation>Lässt die Tasten stehen, die das tun oder so heißen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>All keys, by the menu or the part of the window in which they work</source>
        <translation>Alle Tasten, nach dem Menü oder dem Teil des Fensters, in dem sie wirken</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Wirkung</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
</context>
<context>
    <name>codewheel::KnownBeforeBar</name>
    <message>
        <source>Is it the same encoder? Before it was connected anew this was known: %1 (%2).</source>
        <translation>Ist es derselbe Geber? Vor dem neuen Verbinden war bekannt: %1 (%2).</translation>
    </message>
    <message>
        <source>The sa&amp;me</source>
        <translation>Dersel&amp;be</translation>
    </message>
    <message>
        <source>An&amp;other one</source>
        <translation>Ein an&amp;derer</translation>
    </message>
</context>
<context>
    <name>codewheel::KnownPage</name>
    <message>
        <source>What is known</source>
        <translation>Was bekannt ist</translation>
    </message>
    <message>
        <source>&amp;Read from encoder</source>
        <translation>Aus&amp;lesen</translation>
    </message>
    <message>
        <source>&amp;Set manually</source>
        <translation>&amp;Eintragen</translation>
    </message>
    <message>
        <source>It is in &amp;position mode</source>
        <translation>Er ist im &amp;Positionsbetrieb</translation>
    </message>
    <message>
        <source>What is known of the encoder</source>
        <translation>Was vom Geber bekannt ist</translation>
    </message>
    <message>
        <source>Say what the encoder has, for instance from its papers. Nothing is sent.</source>
        <translation>Eintragen, was der Geber hat, etwa aus seinen Unterlagen. Gesendet wird nichts.</translation>
    </message>
    <message>
        <source>Say that the encoder is in position mode, not in velocity or cam mode. Setting the position would change a cam otherwise.</source>
        <translation>Angeben, dass der Geber im Positionsbetrieb ist, nicht im Drehzahl- oder Nockenbetrieb. Das Setzen der Position würde sonst einen Nocken ändern.</translation>
    </message>
    <message>
        <source>The %1 has no read-out. Only what was written from here, or set manually, is known.</source>
        <translation>Der Geber %1 kennt kein Auslesen. Bekannt ist nur, was von hier geschrieben oder von Hand eingetragen wurde.</translation>
    </message>
    <message>
        <source>Mode not known: position, velocity or cam</source>
        <translation>Betriebsart unbekannt: Position, Drehzahl oder Nocken</translation>
    </message>
    <message>
        <source>Position mode</source>
        <translation>Positionsbetrieb</translation>
    </message>
    <message>
        <source>Velocity mode</source>
        <translation>Drehzahlbetrieb</translation>
    </message>
    <message>
        <source>Cam mode</source>
        <translation>Nockenbetrieb</translation>
    </message>
    <message>
        <source>All values were read.</source>
        <translation>Alle Werte sind ausgelesen.</translation>
    </message>
    <message>
        <source>%1, from its papers:</source>
        <translation>%1, laut Unterlagen:</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1, from its label:</source>
        <translation>%1, vom Typenschild:</translation>
    </message>
    <message>
        <source>Reads all values.</source>
        <translation>Liest alle Werte aus.</translation>
    </message>
    <message>
        <source>Reading sends requests, which change nothing.</source>
        <translation>Auslesen sendet Anfragen, die nichts ändern.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Reads all values. Each one hides the position for some cycles.</source>
        <translation>Liest alle Werte aus. Die Position fehlt jeweils für einige Zyklen.</translation>
    </message>
    <message>
        <source>Reading sends words: the position is hidden for some cycles. Needs Operate.</source>
        <translation>Auslesen sendet Worte: Die Position fehlt für einige Zyklen. Nur in Bedienen möglich.</translation>
    </message>
    <message>
        <source>Reading, step %1 of %2…</source>
        <translation>Auslesen, Schritt %1 von %2…</translation>
    </message>
</context>
<context>
    <name>codewheel::KnownWords</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>read</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>quittiert</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>It was read from the encoder.</source>
        <translation>Aus dem Geber ausgelesen.</translation>
    </message>
    <message>
        <source>Confirmed in a handshake, but not read back since: read it.</source>
        <translation>Im Handshake quittiert, seitdem aber nicht zurückgelesen: auslesen.</translation>
    </message>
    <message>
        <source>Confirmed in a handshake; the encoder cannot be read.</source>
        <translation>Im Handshake quittiert; der Geber lässt sich nicht auslesen.</translation>
    </message>
    <message>
        <source>Not known: read it from the encoder.</source>
        <translation>Unbekannt: aus dem Geber lesen.</translation>
    </message>
    <message>
        <source>Not known, and the encoder cannot be read: set it manually, or write it.</source>
        <translation>Unbekannt, und der Geber lässt sich nicht auslesen: von Hand setzen oder schreiben.</translation>
    </message>
    <message>
        <source>Set manually or by the plan of the bus, not by the encoder: read it.</source>
        <translation>Von Hand oder durch den Busplan gesetzt, nicht vom Geber gemeldet: auslesen.</translation>
    </message>
    <message>
        <source>Set manually or by the plan of the bus; the encoder cannot be read.</source>
        <translation>Von Hand oder durch den Busplan gesetzt; der Geber lässt sich nicht auslesen.</translation>
    </message>
    <message>
        <source>It is stored: the encoder keeps it without supply.</source>
        <translation>Gespeichert: Der Geber behält den Wert auch ohne Versorgung.</translation>
    </message>
    <message>
        <source>It is not stored: without supply the encoder loses it.</source>
        <translation>Nicht gespeichert: Ohne Versorgung verliert der Geber den Wert.</translation>
    </message>
    <message>
        <source>Whether it is stored is not known.</source>
        <translation>Ob der Wert gespeichert ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>not stored</source>
        <translation>nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>codewheel::LabelKey</name>
    <message>
        <source>any letters or digits, %1 in all</source>
        <translation>beliebige Buchstaben oder Ziffern, insgesamt %1</translation>
    </message>
</context>
<context>
    <name>codewheel::Leaving</name>
    <message>
        <source>OUT %1 is %2</source>
        <translation>OUT %1 ist %2</translation>
    </message>
    <message>
        <source>Quit Codewheel</source>
        <translation>Codewheel beenden</translation>
    </message>
    <message>
        <source>Stop the bus</source>
        <translation>Bus anhalten</translation>
    </message>
    <message>
        <source>Not all OUT words are 00000000.</source>
        <translation>Nicht alle OUT-Worte sind 00000000.</translation>
    </message>
    <message>
        <source>Set them to 00000000 (normal running) first?</source>
        <translation>Sollen sie zuerst auf 00000000 (Normalbetrieb) gesetzt werden?</translation>
    </message>
    <message>
        <source>Set to &amp;00000000</source>
        <translation>Auf &amp;00000000 setzen</translation>
    </message>
    <message>
        <source>Sends 00000000 to these devices, then goes on</source>
        <translation>Sendet 00000000 an diese Geräte und macht dann weiter</translation>
    </message>
    <message>
        <source>Nothing can be sent now: the bus is stopped, or in Watch</source>
        <translation>Jetzt lässt sich nichts senden: Der Bus ist angehalten oder steht auf Beobachten</translation>
    </message>
    <message>
        <source>&amp;Leave as they are</source>
        <translation>&amp;Unverändert lassen</translation>
    </message>
    <message>
        <source>Goes on without sending anything</source>
        <translation>Macht weiter, ohne etwas zu senden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>The job on %1 has ended before an answer was given.</source>
        <translation>Der Auftrag an %1 hat geendet, bevor eine Antwort gegeben wurde.</translation>
    </message>
    <message>
        <source>Its result stands in the messages. %1 all the same?</source>
        <translation>Sein Ergebnis steht in den Meldungen. Trotzdem: %1?</translation>
    </message>
    <message>
        <source>%1. The encoder is in parameterization, and stays there without a position until run is sent. %2</source>
        <comment>OUT 1.0 is 020000FF, sentences</comment>
        <translation>%1. Der Geber ist in der Parametrierung und bleibt dort ohne Position, bis Run gesendet wird. %2</translation>
    </message>
    <message>
        <source>An encoder has been left in parameterization.</source>
        <translation>Ein Geber blieb in der Parametrierung.</translation>
    </message>
    <message>
        <source>What shall be sent first?</source>
        <translation>Was soll zuvor gesendet werden?</translation>
    </message>
    <message>
        <source>Send &amp;run, then 00000000</source>
        <translation>&amp;Run senden, dann 00000000</translation>
    </message>
    <message>
        <source>Sends 80000000 to the encoders in parameterization, and 00000000 to all devices named, then goes on</source>
        <translation>Sendet 80000000 an die Geber in der Parametrierung und 00000000 an alle genannten Geräte, und fährt dann fort</translation>
    </message>
    <message>
        <source>Sends 00000000 to these devices, then goes on. What is in parameterization stays there</source>
        <translation>Sendet 00000000 an diese Geräte und fährt dann fort. Was in der Parametrierung ist, bleibt dort</translation>
    </message>
    <message>
        <source>The outputs may be as they were. The program goes on trying as long as the bus stays connected; afterwards nobody does. Stop the machine by its own means.</source>
        <translation>Die Ausgänge können sein, wie sie waren. Das Programm versucht es weiter, solange der Bus verbunden bleibt; danach tut es niemand mehr. Die Maschine mit ihren eigenen Mitteln anhalten.</translation>
    </message>
    <message>
        <source>&amp;Give up, and go on</source>
        <translation>Auf&amp;geben und fortfahren</translation>
    </message>
    <message>
        <source>The zeros are not sent any more</source>
        <translation>Die Nullen werden nicht mehr gesendet</translation>
    </message>
    <message>
        <source>&amp;Keep trying</source>
        <translation>&amp;Weiter versuchen</translation>
    </message>
    <message>
        <source>Nothing says that the zeros of the ALARM STOP have arrived.</source>
        <translation>Nichts sagt, dass die Nullen des ALARM-STOPPs angekommen sind.</translation>
    </message>
    <message>
        <source>The question has just changed: read it first</source>
        <translation>Die Frage hat sich gerade geändert: erst lesen</translation>
    </message>
    <message>
        <source>Nothing can be sent now: the link is lost</source>
        <translation>Jetzt lässt sich nichts senden: Die Verbindung ist unterbrochen</translation>
    </message>
    <message>
        <source>OUT %1 was %2 when last seen, and the encoder was in parameterization</source>
        <translation>OUT %1 war %2, als es zuletzt gesehen wurde, und der Geber war in der Parametrierung</translation>
    </message>
    <message>
        <source>OUT %1 was %2 when last seen</source>
        <translation>OUT %1 war %2, als es zuletzt gesehen wurde</translation>
    </message>
    <message>
        <source>The link is lost.</source>
        <translation>Die Verbindung ist unterbrochen.</translation>
    </message>
    <message>
        <source>%1. Leave them as they are?</source>
        <comment>why nothing can be sent</comment>
        <translation>%1. Unverändert lassen?</translation>
    </message>
    <message>
        <source>OUT is 00000000 already</source>
        <translation>OUT ist schon 00000000</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>OUT 1.0 is 020000FF, a sentence</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>An encoder has not been left in position mode.</source>
        <translation>Ein Geber blieb nicht im Positionsbetrieb.</translation>
    </message>
    <message>
        <source>Leave it as it is? Otherwise cancel, and switch it to position mode.</source>
        <translation>So lassen? Sonst abbrechen und in den Positionsbetrieb schalten.</translation>
    </message>
</context>
<context>
    <name>codewheel::LedRow</name>
    <message>
        <source>UL, supply: the device has its voltage</source>
        <translation>UL, Versorgung: Der Teilnehmer hat Spannung</translation>
    </message>
    <message>
        <source>RC, remote bus check: the incoming bus is in order</source>
        <translation>RC, Remote Bus Check: Der ankommende Bus ist in Ordnung</translation>
    </message>
    <message>
        <source>BA, bus active: on while data cycles run, blinking while they do not</source>
        <translation>BA, Bus Active: leuchtet, während Datenzyklen laufen, sonst blinkt sie</translation>
    </message>
    <message>
        <source>RBDA, remote bus disabled: the outgoing bus is switched off</source>
        <translation>RBDA, Remote Bus Disabled: Der abgehende Bus ist abgeschaltet</translation>
    </message>
    <message>
        <source>LEDs: %1</source>
        <translation>LEDs: %1</translation>
    </message>
    <message>
        <source>LEDs: not known. %1</source>
        <comment>why</comment>
        <translation>LEDs: unbekannt. %1</translation>
    </message>
</context>
<context>
    <name>codewheel::LineTraining</name>
    <message>
        <source>Speed %1 rpm.</source>
        <translation>Drehzahl %1 U/min.</translation>
    </message>
    <message>
        <source>Lost bytes: %1 of 1000.</source>
        <translation>Verlorene Bytes: %1 von 1000.</translation>
    </message>
    <message>
        <source>Wrong bytes: %1 of 1000.</source>
        <translation>Falsche Bytes: %1 von 1000.</translation>
    </message>
    <message>
        <source>Doubled bytes: %1 of 1000.</source>
        <translation>Doppelte Bytes: %1 von 1000.</translation>
    </message>
    <message>
        <source>Delayed bytes: %1 of 1000.</source>
        <translation>Verzögerte Bytes: %1 von 1000.</translation>
    </message>
    <message>
        <source>Echo on.</source>
        <translation>Echo ein.</translation>
    </message>
    <message>
        <source>Echo off.</source>
        <translation>Echo aus.</translation>
    </message>
    <message>
        <source>All encoders silent.</source>
        <translation>Alle Geber stumm.</translation>
    </message>
    <message>
        <source>All encoders answer.</source>
        <translation>Alle Geber antworten.</translation>
    </message>
    <message>
        <source>Adapter unplugged.</source>
        <translation>Adapter abgezogen.</translation>
    </message>
    <message>
        <source>Adapter plugged in.</source>
        <translation>Adapter eingesteckt.</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Eingeschaltet</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Battery nearly flat</source>
        <translation>Batterie fast leer</translation>
    </message>
    <message>
        <source>Battery flat</source>
        <translation>Batterie leer</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>Zu heiß</translation>
    </message>
    <message>
        <source>Light control at its end</source>
        <translation>Lichtregelung am Ende</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>VR at +UB</source>
        <translation>VR an +UB</translation>
    </message>
    <message>
        <source>ST open</source>
        <translation>ST offen</translation>
    </message>
    <message>
        <source>%1: yes.</source>
        <translation>%1: ja.</translation>
    </message>
    <message>
        <source>%1: no.</source>
        <translation>%1: nein.</translation>
    </message>
</context>
<context>
    <name>codewheel::LinkFiguresModel</name>
    <message>
        <source>Exchanges per second</source>
        <translation>Austausche je Sekunde</translation>
    </message>
    <message>
        <source>Exchanges</source>
        <translation>Austausche</translation>
    </message>
    <message>
        <source>Transactions</source>
        <translation>Transaktionen</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Time-outs</source>
        <translation>Zeitüberschreitungen</translation>
    </message>
    <message>
        <source>Wrong answers</source>
        <translation>Falsche Antworten</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Connections lost</source>
        <translation>Verlorene Verbindungen</translation>
    </message>
    <message>
        <source>Words not believed</source>
        <translation>Nicht geglaubte Worte</translation>
    </message>
    <message>
        <source>Round trip, shortest, ms</source>
        <translation>Umlaufzeit, kürzeste, ms</translation>
    </message>
    <message>
        <source>Round trip, median, ms</source>
        <translation>Umlaufzeit, Median, ms</translation>
    </message>
    <message>
        <source>Round trip, longest, ms</source>
        <translation>Umlaufzeit, längste, ms</translation>
    </message>
    <message>
        <source>Exceptions %1</source>
        <translation>Exceptions %1</translation>
    </message>
    <message>
        <source>Stray bytes</source>
        <translation>Verirrte Bytes</translation>
    </message>
    <message>
        <source>Echoes of requests</source>
        <translation>Echos von Anfragen</translation>
    </message>
    <message>
        <source>Closed while idle</source>
        <translation>In Ruhe geschlossen</translation>
    </message>
    <message>
        <source>Connections that the gateway closed while nothing was sent</source>
        <translation>Verbindungen, die das Gateway geschlossen hat, während nichts gesendet wurde</translation>
    </message>
    <message>
        <source>Closed after each answer</source>
        <translation>Nach jeder Antwort geschlossen</translation>
    </message>
    <message>
        <source>Connections that the gateway closed after an answer</source>
        <translation>Verbindungen, die das Gateway nach einer Antwort geschlossen hat</translation>
    </message>
</context>
<context>
    <name>codewheel::MainWindow</name>
    <message>
        <source>About Codewheel</source>
        <translation>Über Codewheel</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Codewheel %1&lt;/h3&gt;&lt;p&gt;Sets up, watches and diagnoses absolute encoders on INTERBUS.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes without any warranty.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Codewheel %1&lt;/h3&gt;&lt;p&gt;Richtet Absolutgeber am INTERBUS ein, beobachtet sie und findet Fehler.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Ohne jede Gewährleistung.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pages in the middle</source>
        <translation>Seiten in der Mitte</translation>
    </message>
    <message>
        <source>The whole window</source>
        <translation>Das ganze Fenster</translation>
    </message>
    <message>
        <source>%1 is not in the bus structure: it is neither connected nor in the project.</source>
        <translation>%1 ist nicht im Busaufbau: weder verbunden noch im Projekt.</translation>
    </message>
    <message>
        <source>A sequence is being sent: it stays until that has ended.</source>
        <translation>Eine Sequenz wird gerade gesendet: Sie bleibt, bis das zu Ende ist.</translation>
    </message>
    <message>
        <source>Bits of a word</source>
        <translation>Bits eines Worts</translation>
    </message>
    <message>
        <source>Table of parameters</source>
        <translation>Tabelle der Parameter</translation>
    </message>
    <message>
        <source>Ruler of the cams</source>
        <translation>Lineal der Nocken</translation>
    </message>
    <message>
        <source>Table of the cams</source>
        <translation>Tabelle der Nocken</translation>
    </message>
    <message>
        <source>Saved for support: %1</source>
        <translation>Für den Support gespeichert: %1</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Monitor eines Geräts</translation>
    </message>
    <message>
        <source>Writes OUT</source>
        <translation>Schreibt OUT</translation>
    </message>
    <message>
        <source>Discards what is staged</source>
        <translation>Verwirft, was vorgemerkt ist</translation>
    </message>
    <message>
        <source>Structure editor</source>
        <translation>Busaufbau bearbeiten</translation>
    </message>
    <message>
        <source>Finds a device</source>
        <translation>Sucht ein Gerät</translation>
    </message>
    <message>
        <source>The next one found, or the one before</source>
        <translation>Der nächste Treffer oder der davor</translation>
    </message>
    <message>
        <source>Selects the word that was typed, or sends it (At once)</source>
        <translation>Markiert das eingegebene Wort oder sendet es (bei „Sofort“)</translation>
    </message>
    <message>
        <source>Copies a number that has the focus</source>
        <translation>Kopiert die Zahl mit dem Fokus</translation>
    </message>
    <message>
        <source>Takes what was typed</source>
        <translation>Übernimmt die Eingabe</translation>
    </message>
    <message>
        <source>Brings back what stood there before</source>
        <translation>Stellt wieder her, was vorher da stand</translation>
    </message>
    <message>
        <source>Makes a number larger or smaller</source>
        <translation>Macht eine Zahl größer oder kleiner</translation>
    </message>
    <message>
        <source>Programs of the cams</source>
        <translation>Nockenprogramme</translation>
    </message>
    <message>
        <source>Filter of the bus structure</source>
        <translation>Filter des Busaufbaus</translation>
    </message>
    <message>
        <source>Messages, trace, terminal</source>
        <translation>Meldungen, Handshake-Protokoll, Terminal</translation>
    </message>
    <message>
        <source>Opens the menu of the row</source>
        <translation>Öffnet das Menü der Zeile</translation>
    </message>
    <message>
        <source>Closes the insert panel</source>
        <translation>Schließt den Bereich zum Einfügen</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt benutzte Projekte</translation>
    </message>
    <message>
        <source>Opens the project</source>
        <translation>Öffnet das Projekt</translation>
    </message>
    <message>
        <source>Takes it off the list</source>
        <translation>Nimmt es aus der Liste</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Eingabefelder</translation>
    </message>
    <message>
        <source>Pages, reviews, questions</source>
        <translation>Seiten, Prüfungen, Fragen</translation>
    </message>
    <message>
        <source>Closes it, or goes back</source>
        <translation>Schließt sie oder geht zurück</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.cwrec);;All files (*)</source>
        <translation>Aufzeichnungen (*.cwrec);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 has cam programs: choose an encoder with cams in the bus structure, and they are opened for it.</source>
        <translation>%1 enthält Nockenprogramme: im Busaufbau einen Geber mit Nocken wählen, dann werden sie für ihn geöffnet.</translation>
    </message>
    <message>
        <source>%1 is a fault plan: it can be loaded once a training ring is connected.</source>
        <translation>%1 ist ein Fehlerplan: Er kann geladen werden, sobald ein Übungsring verbunden ist.</translation>
    </message>
    <message>
        <source>&amp;Training bus</source>
        <translation>Übu&amp;ngsbus</translation>
    </message>
    <message>
        <source>The window is made anew once the transfer has ended.</source>
        <translation>Das Fenster wird neu aufgebaut, sobald die Übertragung zu Ende ist.</translation>
    </message>
</context>
<context>
    <name>codewheel::MasterPanel</name>
    <message>
        <source>Master</source>
        <translation>Master</translation>
    </message>
    <message numerus="yes">
        <source>%n devices found</source>
        <translation>
            <numerusform>%n Teilnehmer gefunden</numerusform>
            <numerusform>%n Teilnehmer gefunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>What is wrong, and where</source>
        <translation>Was nicht stimmt, und wo</translation>
    </message>
    <message>
        <source>Error code</source>
        <translation>Fehlercode</translation>
    </message>
    <message>
        <source>As the firmware&apos;s manual lists it</source>
        <translation>Wie ihn das Handbuch der Firmware aufführt</translation>
    </message>
    <message>
        <source>Diagnostic parameter</source>
        <translation>Diagnoseparameter</translation>
    </message>
    <message>
        <source>Segment and position of the fault; 0080h: not located</source>
        <translation>Segment und Position des Fehlers; 0080h: nicht geortet</translation>
    </message>
    <message>
        <source>Stored configuration</source>
        <translation>Gespeicherte Konfiguration</translation>
    </message>
    <message>
        <source>The configuration stored in the master, by its file</source>
        <translation>Die im Master gespeicherte Konfiguration, mit dem Namen ihrer Datei</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Activates the configuration, and starts data transfer</source>
        <translation>Aktiviert die Konfiguration und startet die Datenübertragung</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops data transfer</source>
        <translation>Hält die Datenübertragung an</translation>
    </message>
    <message>
        <source>Read in the ring</source>
        <translation>Ring einlesen</translation>
    </message>
    <message>
        <source>Stops the ring, finds its devices one by one, and starts it again</source>
        <translation>Hält den Ring an, sucht seine Teilnehmer der Reihe nach und startet ihn wieder</translation>
    </message>
    <message>
        <source>Confirm diagnostics</source>
        <translation>Diagnose quittieren</translation>
    </message>
    <message>
        <source>Confirms peripheral faults; one whose cause is still there comes back</source>
        <translation>Quittiert Peripheriefehler; einer, dessen Ursache noch da ist, kommt wieder</translation>
    </message>
    <message>
        <source>Reading in the ring</source>
        <translation>Ring wird eingelesen</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>A segment is a remote-bus device and the cable before it</source>
        <translation>Ein Segment ist ein Fernbusteilnehmer und das Kabel davor</translation>
    </message>
    <message>
        <source>Master %1</source>
        <translation>Master %1</translation>
    </message>
    <message>
        <source>This link does not reach the master.</source>
        <translation>Diese Verbindung erreicht den Master nicht.</translation>
    </message>
    <message>
        <source>%1: not located</source>
        <translation>%1: nicht geortet</translation>
    </message>
    <message>
        <source>no configuration</source>
        <translation>keine Konfiguration</translation>
    </message>
    <message>
        <source>Switch segment %1 on</source>
        <translation>Segment %1 zuschalten</translation>
    </message>
    <message>
        <source>Switch segment %1 off</source>
        <translation>Segment %1 abschalten</translation>
    </message>
    <message>
        <source>Its devices, and those behind them, take part in the data cycles again</source>
        <translation>Seine Teilnehmer und die dahinter nehmen wieder an den Datenzyklen teil</translation>
    </message>
    <message>
        <source>Its devices, and those behind them, take no part in the data cycles; their outputs go to 0</source>
        <translation>Seine Teilnehmer und die dahinter nehmen nicht mehr an den Datenzyklen teil; ihre Ausgänge gehen auf 0</translation>
    </message>
    <message>
        <source>Switch o&amp;ff</source>
        <translation>A&amp;bschalten</translation>
    </message>
    <message>
        <source>&amp;Leave it on</source>
        <translation>Eingeschaltet &amp;lassen</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weiteres</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>OUT %1 is %2</source>
        <translation>OUT %1 ist %2</translation>
    </message>
    <message>
        <source>Switch segment %1 off? Out of the data cycles go: %2.</source>
        <translation>Segment %1 abschalten? Aus den Datenzyklen gehen: %2.</translation>
    </message>
    <message numerus="yes">
        <source>The outputs of %n devices go to 0.</source>
        <translation>
            <numerusform>Die Ausgänge von %n Gerät gehen auf 0.</numerusform>
            <numerusform>Die Ausgänge von %n Geräten gehen auf 0.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not 0 now: %1.</source>
        <translation>Jetzt nicht 0: %1.</translation>
    </message>
    <message>
        <source>Link lost: as the master was before</source>
        <translation>Verbindung verloren: so stand der Master zuvor</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
</context>
<context>
    <name>codewheel::MessageDetails</name>
    <message>
        <source>Details of the message</source>
        <translation>Einzelheiten der Meldung</translation>
    </message>
    <message>
        <source>%1 times from %2 to %3</source>
        <comment>count, date and time</comment>
        <translation>%1-mal von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>codewheel::MessageFilterBar</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search in messages</source>
        <translation>In Meldungen suchen</translation>
    </message>
    <message>
        <source>Show only messages with this text (Ctrl+F)</source>
        <translation>Nur Meldungen mit diesem Text zeigen (Strg+F)</translation>
    </message>
    <message>
        <source>Attention and faults</source>
        <translation>Achtung und Störungen</translation>
    </message>
    <message>
        <source>Faults only</source>
        <translation>Nur Störungen</translation>
    </message>
    <message>
        <source>Severity of messages</source>
        <translation>Stufe der Meldungen</translation>
    </message>
    <message>
        <source>Show only messages of this severity or worse</source>
        <translation>Nur Meldungen dieser oder einer höheren Stufe zeigen</translation>
    </message>
    <message>
        <source>Place of messages</source>
        <translation>Ort der Meldungen</translation>
    </message>
    <message>
        <source>Since the start</source>
        <translation>Seit dem Start</translation>
    </message>
    <message>
        <source>Last hour</source>
        <translation>Letzte Stunde</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Time of messages</source>
        <translation>Zeit der Meldungen</translation>
    </message>
    <message>
        <source>Show only messages of this time; the start is that of the program</source>
        <translation>Nur Meldungen dieser Zeit zeigen; der Start ist der des Programms</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>Show messages from this date and time on</source>
        <translation>Meldungen von diesem Zeitpunkt an zeigen</translation>
    </message>
    <message>
        <source>&amp;to</source>
        <translation>&amp;bis</translation>
    </message>
    <message>
        <source>Show messages before this date and time</source>
        <translation>Meldungen vor diesem Zeitpunkt zeigen</translation>
    </message>
    <message>
        <source>Show only messages of this device, of this bus and its devices, or of no device</source>
        <translation>Nur Meldungen dieses Teilnehmers, dieses Busses mit seinen Teilnehmern oder keines Teilnehmers zeigen</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Teilnehmer</translation>
    </message>
    <message>
        <source>All</source>
        <comment>messages</comment>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>From … to …</source>
        <translation>Von … bis …</translation>
    </message>
</context>
<context>
    <name>codewheel::MessageModel</name>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 (%2 times since %3)</source>
        <comment>message, count, time</comment>
        <translation>%1 (%2-mal seit %3)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>date and time</comment>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>codewheel::MessageWriter</name>
    <message>
        <source>Messages of Codewheel</source>
        <translation>Meldungen von Codewheel</translation>
    </message>
    <message>
        <source>Written on %1.</source>
        <translation>Geschrieben am %1.</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
</context>
<context>
    <name>codewheel::MessagesView</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the messages chosen, or all that are shown (Ctrl+C)</source>
        <translation>Die gewählten Meldungen kopieren, oder alle gezeigten (Strg+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>List of messages</source>
        <translation>Liste der Meldungen</translation>
    </message>
    <message>
        <source>No messages yet</source>
        <translation>Noch keine Meldungen</translation>
    </message>
    <message>
        <source>What happens to the bus and its devices is listed here.</source>
        <translation>Hier steht, was am Bus und an seinen Geräten geschieht.</translation>
    </message>
    <message>
        <source>Change it, or show all messages.</source>
        <translation>Den Filter ändern oder alle Meldungen zeigen.</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Export messages</source>
        <translation>Meldungen exportieren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>messages.csv</source>
        <comment>name of a file</comment>
        <translation>meldungen.csv</translation>
    </message>
    <message>
        <source>Messages written to %1: %2.</source>
        <translation>Meldungen nach %1 geschrieben: %2.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2. Choose another folder or name.</source>
        <translation>%1 ließ sich nicht schreiben: %2. Einen anderen Ordner oder Namen wählen.</translation>
    </message>
    <message>
        <source>State of the search</source>
        <translation>Stand der Suche</translation>
    </message>
    <message>
        <source>Write the messages shown to a file (CSV or HTML)</source>
        <translation>Die gezeigten Meldungen in eine Datei schreiben (CSV oder HTML)</translation>
    </message>
    <message>
        <source>Hide all messages up to now; they are kept on disk</source>
        <translation>Alle Meldungen bis jetzt ausblenden; auf der Festplatte bleiben sie erhalten</translation>
    </message>
    <message>
        <source>Bring back what was cleared</source>
        <translation>Ausgeblendetes zurückholen</translation>
    </message>
    <message>
        <source>Show the messages again that were hidden by Clear</source>
        <translation>Die ausgeblendeten Meldungen wieder zeigen</translation>
    </message>
    <message>
        <source>No message found so far</source>
        <translation>Bisher keine Meldung gefunden</translation>
    </message>
    <message>
        <source>The search goes on.</source>
        <translation>Die Suche läuft weiter.</translation>
    </message>
    <message>
        <source>searching: %1 %</source>
        <translation>Suche: %1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n gefunden</numerusform>
            <numerusform>%n gefunden</numerusform>
        </translation>
    </message>
    <message>
        <source>The messages up to now are hidden. They are kept on disk.</source>
        <translation>Die Meldungen bis jetzt sind ausgeblendet. Auf der Festplatte bleiben sie erhalten.</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Seite (*.html)</translation>
    </message>
    <message>
        <source>Writing %1: %2 %</source>
        <translation>%1 wird geschrieben: %2 %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Show all of the chosen message below the list (Enter)</source>
        <translation>Die gewählte Meldung ganz unter der Liste zeigen (Eingabe)</translation>
    </message>
    <message>
        <source>Keep the newest message in view (Ctrl+End)</source>
        <translation>Automatisch folgen: Die neueste Meldung bleibt im Blick (Strg+Ende)</translation>
    </message>
    <message>
        <source>No message matches the filter</source>
        <translation>Keine Meldung passt zum Filter</translation>
    </message>
</context>
<context>
    <name>codewheel::MissingValues</name>
    <message>
        <source>&amp;Read what is missing</source>
        <translation>&amp;Fehlendes auslesen</translation>
    </message>
    <message>
        <source>Read what the dial needs</source>
        <translation>Auslesen, was die Anzeige braucht</translation>
    </message>
    <message>
        <source>Reads what the dial needs from the encoder. That sends words, and hides the position for some cycles.</source>
        <translation>Liest aus dem Geber, was die Anzeige braucht. Das sendet Worte; die Position fehlt für einige Zyklen.</translation>
    </message>
    <message>
        <source>Its mode cannot be read: position, velocity or cam. It is known once you say it, or switch it from here.</source>
        <translation>Die Betriebsart lässt sich nicht auslesen: Position, Drehzahl oder Nocken. Bekannt ist sie, sobald sie von Hand eingetragen oder von hier aus umgeschaltet ist.</translation>
    </message>
    <message>
        <source>It is in &amp;position mode</source>
        <translation>Er ist im &amp;Positionsbetrieb</translation>
    </message>
</context>
<context>
    <name>codewheel::ModeSwitch</name>
    <message>
        <source>Watch or Operate</source>
        <translation>Beobachten oder Bedienen</translation>
    </message>
</context>
<context>
    <name>codewheel::MonitorArea</name>
    <message>
        <source>No monitor is open</source>
        <translation>Kein Monitor geöffnet</translation>
    </message>
    <message>
        <source>%1 has no words to show: it takes no part in the process data.</source>
        <translation>%1 hat keine Worte zu zeigen: Prozessdaten gibt es hier nicht.</translation>
    </message>
    <message>
        <source>%1 is not connected: its words are shown once it is.</source>
        <translation>%1 ist nicht verbunden: Die Worte werden gezeigt, sobald die Verbindung besteht.</translation>
    </message>
    <message>
        <source>A monitor shows the words of a device, and lets you set the bits of its OUT word. Choose a device in the bus structure.</source>
        <translation>Ein Monitor zeigt die Worte eines Geräts und setzt die Bits seines OUT-Worts. Ein Gerät im Busaufbau wählen.</translation>
    </message>
    <message>
        <source>%1 has no words: its position is in the panels, the traffic of its bus in the terminal.</source>
        <translation>%1 hat keine Worte: Die Position steht in den Bereichen am Rand, der Verkehr auf dem Bus im Terminal.</translation>
    </message>
</context>
<context>
    <name>codewheel::NamingBar</name>
    <message>
        <source>Name it</source>
        <translation>Benennen</translation>
    </message>
    <message>
        <source>Key on the label</source>
        <translation>Schlüssel auf dem Typenschild</translation>
    </message>
    <message>
        <source>Type the key on the label of the encoder. Spaces, dots and dashes do not matter.</source>
        <translation>Den Schlüssel vom Typenschild des Gebers eingeben. Leerzeichen, Punkte und Striche spielen keine Rolle.</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>The encoders of the catalog with this device code</source>
        <translation>Die Geber des Katalogs mit diesem Gerätecode</translation>
    </message>
    <message>
        <source>Label key</source>
        <translation>Typenschlüssel</translation>
    </message>
    <message>
        <source>Which encoder is %1? The bus tells its device code (%2) but not its make.</source>
        <translation>Welcher Geber ist %1? Der Bus nennt den Gerätecode (%2), aber nicht den Hersteller.</translation>
    </message>
    <message>
        <source>make not known</source>
        <translation>Hersteller unbekannt</translation>
    </message>
    <message>
        <source>%1: %2 turns, %3 steps per turn</source>
        <translation>%1: %2 Umdrehungen, %3 Schritte je Umdrehung</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Treats the device as this encoder from now on. Nothing is sent; what was known of it is forgotten.</source>
        <translation>Das Gerät gilt ab jetzt als dieser Geber. Gesendet wird nichts; was über ihn bekannt war, ist vergessen.</translation>
    </message>
    <message>
        <source>%1 has been named. Choose &quot;make not known&quot; to undo that.</source>
        <translation>%1 ist benannt. „Hersteller unbekannt“ nimmt das zurück.</translation>
    </message>
</context>
<context>
    <name>codewheel::NoteBar</name>
    <message>
        <source>&amp;Set note</source>
        <translation>Notiz &amp;setzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Marks this moment with the text; an empty text removes the note (Return)</source>
        <translation>Markiert diesen Zeitpunkt mit dem Text; ein leerer Text entfernt die Notiz (Eingabe)</translation>
    </message>
    <message>
        <source>Changes nothing (Esc)</source>
        <translation>Ändert nichts (Esc)</translation>
    </message>
    <message>
        <source>Text of the note</source>
        <translation>Text der Notiz</translation>
    </message>
    <message>
        <source>What happened at this moment</source>
        <translation>Was zu diesem Zeitpunkt geschah</translation>
    </message>
    <message>
        <source>Note at %1:</source>
        <comment>a time of day</comment>
        <translation>Notiz um %1:</translation>
    </message>
</context>
<context>
    <name>codewheel::NowAndThen</name>
    <message>
        <source>What it will show then is not known.</source>
        <translation>Was er danach zeigt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>What it will show then is not known. Missing: %1.</source>
        <translation>Was er danach zeigt, ist nicht bekannt. Es fehlt: %1.</translation>
    </message>
</context>
<context>
    <name>codewheel::NumberField</name>
    <message>
        <source>Copy this number</source>
        <translation>Diese Zahl kopieren</translation>
    </message>
</context>
<context>
    <name>codewheel::NumberFields</name>
    <message>
        <source>%1 hexadecimal</source>
        <comment>OUT 1.0 hexadecimal</comment>
        <translation>%1 hexadezimal</translation>
    </message>
    <message>
        <source>%1 decimal</source>
        <comment>OUT 1.0 decimal</comment>
        <translation>%1 dezimal</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Mit Vorzeichen</translation>
    </message>
    <message>
        <source>%1 signed</source>
        <comment>OUT 1.0 signed</comment>
        <translation>%1 mit Vorzeichen</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Gray</translation>
    </message>
    <message>
        <source>%1 Gray</source>
        <comment>OUT 1.0 Gray</comment>
        <translation>%1 Gray</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binär</translation>
    </message>
    <message>
        <source>%1 binary</source>
        <comment>OUT 1.0 binary</comment>
        <translation>%1 binär</translation>
    </message>
    <message>
        <source>Type the word: 020000FF, 0x020000FF, 20000FFh; spaces are allowed</source>
        <translation>Das Wort eingeben: 020000FF, 0x020000FF, 20000FFh; Leerzeichen sind erlaubt</translation>
    </message>
    <message>
        <source>The whole word as a number</source>
        <translation>Das ganze Wort als Zahl</translation>
    </message>
    <message>
        <source>The whole word as a signed number (two&apos;s complement)</source>
        <translation>Das ganze Wort als Zahl mit Vorzeichen (Zweierkomplement)</translation>
    </message>
    <message>
        <source>The number that the whole word gives when read as Gray code</source>
        <translation>Die Zahl, die das ganze Wort als Gray-Code ergibt</translation>
    </message>
    <message>
        <source>All bits, the highest first</source>
        <translation>Alle Bits, das höchste zuerst</translation>
    </message>
    <message>
        <source>The whole word, as the manuals write it</source>
        <translation>Das ganze Wort, wie es in den Handbüchern steht</translation>
    </message>
    <message>
        <source>%1 as a number</source>
        <comment>D24..D0</comment>
        <translation>%1 als Zahl</translation>
    </message>
    <message>
        <source>%1 as a signed number (two&apos;s complement)</source>
        <comment>D24..D0</comment>
        <translation>%1 als Zahl mit Vorzeichen (Zweierkomplement)</translation>
    </message>
    <message>
        <source>The number that %1 give when read as Gray code</source>
        <comment>D24..D0</comment>
        <translation>Die Zahl, die %1 als Gray-Code gelesen ergeben</translation>
    </message>
</context>
<context>
    <name>codewheel::OfferFiles</name>
    <message>
        <source>This computer has no address in a network: others cannot reach it, and no file can say how. Connect it to the network.</source>
        <translation>Dieser Rechner hat keine Adresse in einem Netz: Andere erreichen ihn nicht, und keine Datei kann sagen, wie. Mit dem Netz verbinden.</translation>
    </message>
    <message>
        <source>Save files</source>
        <translation>Dateien speichern</translation>
    </message>
    <message>
        <source>At which address do the others &amp;reach this computer?</source>
        <translation>Unter welcher Adresse &amp;erreichen die anderen diesen Rechner?</translation>
    </message>
    <message>
        <source>Save a file for clients</source>
        <translation>Datei für Clients speichern</translation>
    </message>
    <message>
        <source>offered-ring.codewheel</source>
        <comment>name of a file</comment>
        <translation>angebotener-ring.codewheel</translation>
    </message>
    <message>
        <source>Codewheel projects (*.codewheel)</source>
        <translation>Codewheel-Projekte (*.codewheel)</translation>
    </message>
    <message>
        <source>Saved: %1. %2</source>
        <translation>Gespeichert: %1. %2</translation>
    </message>
    <message>
        <source>Save files for the seats</source>
        <translation>Dateien für die Sitzplätze speichern</translation>
    </message>
    <message>
        <source>Only the files of the seats before seat %1 were saved. %2</source>
        <translation>Nur die Dateien der Sitzplätze vor Sitzplatz %1 wurden gespeichert. %2</translation>
    </message>
    <message numerus="yes">
        <source>%n files saved in %1. %2</source>
        <translation>
            <numerusform>%n Datei in %1 gespeichert. %2</numerusform>
            <numerusform>%n Dateien in %1 gespeichert. %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files of these names are there already.</source>
        <translation>
            <numerusform>%n Datei dieses Namens ist schon da.</numerusform>
            <numerusform>%n Dateien dieser Namen sind schon da.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. What is in them is kept as %2.</source>
        <translation>%1. Was darin ist, bleibt als %2 erhalten.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Saves the files of all seats, in place of what is there</source>
        <translation>Speichert die Dateien aller Sitzplätze anstelle dessen, was da ist</translation>
    </message>
    <message>
        <source>A Codewheel that opens such a file connects to %1: its computer must reach this one there.</source>
        <translation>Ein Codewheel, das eine solche Datei öffnet, verbindet sich mit %1: Sein Rechner muss diesen dort erreichen.</translation>
    </message>
    <message>
        <source>A Codewheel that opens such a file connects to %1: on this computer only, since it is offered to this computer only.</source>
        <translation>Ein Codewheel, das eine solche Datei öffnet, verbindet sich mit %1: nur auf diesem Rechner, da nur ihm angeboten wird.</translation>
    </message>
</context>
<context>
    <name>codewheel::OfferForm</name>
    <message>
        <source>This computer only: %1</source>
        <translation>Nur dieser Rechner: %1</translation>
    </message>
    <message>
        <source>All addresses of this computer: %1</source>
        <translation>Alle Adressen dieses Rechners: %1</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Whether programs on other computers reach it, and at which address</source>
        <translation>Ob Programme auf anderen Rechnern ihn erreichen und unter welcher Adresse</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>1502, or another free one from 1024 on; 502 is for administrators</source>
        <translation>1502, oder ein anderer freier ab 1024; 502 ist Administratoren vorbehalten</translation>
    </message>
    <message>
        <source>One ring for &amp;all</source>
        <translation>Ei&amp;n Ring für alle</translation>
    </message>
    <message>
        <source>All clients work on the ring of this window, whatever unit they ask</source>
        <translation>Alle Clients arbeiten am Ring dieses Fensters, welche Unit sie auch fragen</translation>
    </message>
    <message>
        <source>A ring for each &amp;seat</source>
        <translation>Je &amp;Sitzplatz ein Ring</translation>
    </message>
    <message>
        <source>Each seat has a ring of its own, with the devices of this one: unit 1 is seat 1. The ring of this window is nobody&apos;s seat</source>
        <translation>Jeder Sitzplatz hat einen eigenen Ring mit den Teilnehmern von diesem: Unit 1 ist Sitzplatz 1. Der Ring dieses Fensters ist niemandes Sitzplatz</translation>
    </message>
    <message>
        <source>Seats</source>
        <translation>Sitzplätze</translation>
    </message>
    <message>
        <source>How many seats there are: 1 to 64</source>
        <translation>Wie viele Sitzplätze es gibt: 1 bis 64</translation>
    </message>
    <message>
        <source>Clients may onl&amp;y read</source>
        <translation>Clients dürfen nur &amp;lesen</translation>
    </message>
    <message>
        <source>What they want to write is refused with exception 1</source>
        <translation>Was sie schreiben wollen, wird mit Exception 1 abgelehnt</translation>
    </message>
    <message>
        <source>any free one</source>
        <translation>ein freier</translation>
    </message>
    <message>
        <source>&amp;Where</source>
        <translation>&amp;Wo</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Sea&amp;ts</source>
        <translation>Si&amp;tzplätze</translation>
    </message>
    <message>
        <source>Modbus has no password: whoever reaches this port in the network may use the ring.</source>
        <translation>Modbus hat kein Passwort: Wer diesen Port im Netz erreicht, darf den Ring benutzen.</translation>
    </message>
    <message>
        <source>Only programs on this computer reach it.</source>
        <translation>Nur Programme auf diesem Rechner erreichen ihn.</translation>
    </message>
</context>
<context>
    <name>codewheel::OfferPage</name>
    <message>
        <source>&amp;Offer</source>
        <translation>Anb&amp;ieten</translation>
    </message>
    <message>
        <source>&amp;Stop offering</source>
        <translation>Nicht &amp;mehr anbieten</translation>
    </message>
    <message>
        <source>Disconnects all clients (Alt+S)</source>
        <translation>Trennt alle Clients (Alt+M)</translation>
    </message>
    <message>
        <source>Other programs can use the simulated ring. Nothing real is offered.</source>
        <translation>Andere Programme können den simulierten Ring benutzen. Nichts Echtes wird angeboten.</translation>
    </message>
    <message>
        <source>Other programs can use the ring from then on (Alt+O)</source>
        <translation>Von da an können andere Programme den Ring benutzen (Alt+I)</translation>
    </message>
    <message>
        <source>Offer to others</source>
        <translation>Anderen anbieten</translation>
    </message>
    <message>
        <source>Projects with which a Codewheel at another seat connects to its ring (Alt+I)</source>
        <translation>Projekte, mit denen sich ein Codewheel an einem anderen Platz mit seinem Ring verbindet (Alt+S)</translation>
    </message>
    <message>
        <source>Save f&amp;iles for the seats…</source>
        <translation>Dateien für Plätze &amp;speichern…</translation>
    </message>
    <message>
        <source>Save a f&amp;ile for clients…</source>
        <translation>Datei für Clients &amp;speichern…</translation>
    </message>
</context>
<context>
    <name>codewheel::OfferViews</name>
    <message>
        <source>A simulated ring is offered to others (Bus &gt; Training &gt; Offer to others)</source>
        <translation>Ein simulierter Ring wird anderen angeboten (Bus &gt; Übung &gt; Anderen anbieten)</translation>
    </message>
    <message>
        <source>Offered at %1, %2</source>
        <translation>Angeboten an %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n clients</source>
        <translation>
            <numerusform>%n Client</numerusform>
            <numerusform>%n Clients</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop offering</source>
        <translation>Nicht mehr anbieten</translation>
    </message>
    <message>
        <source>&amp;Stop offering</source>
        <translation>Nicht &amp;mehr anbieten</translation>
    </message>
    <message>
        <source>Disconnects all clients (Alt+S)</source>
        <translation>Trennt alle Clients (Alt+M)</translation>
    </message>
    <message>
        <source>Stop offering and disconnect all clients?</source>
        <translation>Angebot beenden und alle Clients trennen?</translation>
    </message>
    <message>
        <source>Start seat afresh</source>
        <translation>Sitzplatz neu starten</translation>
    </message>
    <message>
        <source>Give seat %1 a new ring, with factory settings?</source>
        <translation>Sitzplatz %1 einen neuen Ring mit Werkseinstellungen geben?</translation>
    </message>
    <message>
        <source>&amp;Start afresh</source>
        <translation>Neu &amp;starten</translation>
    </message>
    <message>
        <source>The ring of this seat begins anew (Alt+S)</source>
        <translation>Der Ring dieses Sitzplatzes beginnt von vorn (Alt+S)</translation>
    </message>
</context>
<context>
    <name>codewheel::OfferedView</name>
    <message>
        <source>All units are the ring of this window.</source>
        <translation>Alle Units sind der Ring dieses Fensters.</translation>
    </message>
    <message numerus="yes">
        <source>Units 1 to %n are the seats, each with a ring of its own. The ring of this window is not offered.</source>
        <translation>
            <numerusform>Unit %n ist der einzige Sitzplatz, mit einem eigenen Ring. Der Ring dieses Fensters wird nicht angeboten.</numerusform>
            <numerusform>Die Units 1 bis %n sind die Sitzplätze, jeder mit einem eigenen Ring. Der Ring dieses Fensters wird nicht angeboten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Clients may only read.</source>
        <translation>Clients dürfen nur lesen.</translation>
    </message>
    <message>
        <source>It can be reached from other computers, without a password.</source>
        <translation>Er ist von anderen Rechnern erreichbar, ohne Passwort.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copies address and port (Alt+Y)</source>
        <translation>Kopiert Adresse und Port (Alt+K)</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clients</translation>
    </message>
    <message>
        <source>Seats</source>
        <translation>Sitzplätze</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Offered at %1</source>
        <translation>Angeboten an %1</translation>
    </message>
    <message>
        <source>Registers are counted from 0, with the high word first. The status register is %1, the diagnostic parameter %2, as input and as holding registers.</source>
        <translation>Register werden ab 0 gezählt, mit dem oberen Wort zuerst. Das Statusregister ist %1, der Diagnoseparameter %2, als Input- und als Holding-Register.</translation>
    </message>
</context>
<context>
    <name>codewheel::OperateQuestion</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>This ring is real. Shall the program write to it?</source>
        <translation>Dieser Ring ist echt. Soll das Programm in ihn schreiben?</translation>
    </message>
    <message>
        <source>%1 is a real ring. Shall the program write to it?</source>
        <translation>%1 ist ein echter Ring. Soll das Programm in ihn schreiben?</translation>
    </message>
    <message>
        <source>&amp;Operate</source>
        <translation>&amp;Bedienen</translation>
    </message>
    <message>
        <source>&amp;Stay in Watch</source>
        <translation>B&amp;eobachten</translation>
    </message>
    <message>
        <source>Nothing is sent (Esc)</source>
        <translation>Nichts wird gesendet (Esc)</translation>
    </message>
    <message>
        <source>In Operate, the OUT words that you send go to the devices of the ring. A preset or a parameter changes the position that the controller sees. Switching over changes no OUT word.</source>
        <translation>Beim Bedienen gehen die OUT-Worte, die Sie senden, an die Geräte des Rings. Ein Preset oder ein Parameter ändert die Position, die die Steuerung sieht. Das Umschalten ändert kein OUT-Wort.</translation>
    </message>
    <message>
        <source>All devices with OUT words are encoders.</source>
        <translation>Alle Geräte mit OUT-Worten sind Geber.</translation>
    </message>
    <message>
        <source>These devices have OUT words and are not known as encoders. What they drive can move:</source>
        <translation>Diese Geräte haben OUT-Worte und sind nicht als Geber bekannt. Was sie steuern, kann sich bewegen:</translation>
    </message>
    <message>
        <source>OUT cannot be read back of these. It stays as it is until something is sent there:</source>
        <translation>Bei diesen kann OUT nicht zurückgelesen werden. Es bleibt, wie es ist, bis dorthin etwas gesendet wird:</translation>
    </message>
    <message>
        <source>It can be written to from now on; nothing is changed by that. This is not asked again before it is connected anew</source>
        <translation>Ab jetzt kann geschrieben werden; dadurch ändert sich nichts. Erst nach dem nächsten Verbinden wird wieder gefragt</translation>
    </message>
    <message>
        <source>This serial line is real. Shall the program write to it?</source>
        <translation>Diese serielle Leitung ist echt. Soll das Programm auf sie schreiben?</translation>
    </message>
    <message>
        <source>%1 is a real serial line. Shall the program write to it?</source>
        <translation>%1 ist eine echte serielle Leitung. Soll das Programm auf sie schreiben?</translation>
    </message>
    <message>
        <source>In Operate, what you write goes to the encoders on the line. A preset or a parameter changes the position that the controller sees. Switching over sends nothing.</source>
        <translation>Beim Bedienen geht das, was Sie schreiben, an die Geber der Leitung. Ein Preset oder ein Parameter ändert die Position, die die Steuerung sieht. Das Umschalten sendet nichts.</translation>
    </message>
</context>
<context>
    <name>codewheel::OrderingKeyReader</name>
    <message>
        <source>A code consists of the letters A to Z and digits.</source>
        <translation>Ein Code besteht aus den Buchstaben A bis Z und Ziffern.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; cannot be told apart: one begins with the other.</source>
        <translation>„%1“ und „%2“ lassen sich nicht unterscheiden: Eines beginnt mit dem anderen.</translation>
    </message>
    <message>
        <source>A part has either codes or any.</source>
        <translation>Ein Teil hat entweder Codes oder any.</translation>
    </message>
    <message>
        <source>At least one code is expected here.</source>
        <translation>Hier wird mindestens ein Code erwartet.</translation>
    </message>
    <message>
        <source>Another part tells the turns already.</source>
        <translation>Ein anderer Teil nennt die Umdrehungen schon.</translation>
    </message>
    <message>
        <source>Another part tells the steps per turn already.</source>
        <translation>Ein anderer Teil nennt die Schritte je Umdrehung schon.</translation>
    </message>
    <message>
        <source>Only the last part may be optional.</source>
        <translation>Nur der letzte Teil darf optional sein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in the example is not understood by the parts.</source>
        <translation>„%1“ im Beispiel passt zu keinem der Teile.</translation>
    </message>
    <message>
        <source>This code is here twice.</source>
        <translation>Dieser Code steht hier doppelt.</translation>
    </message>
</context>
<context>
    <name>codewheel::Page</name>
    <message>
        <source>What is being written goes on: only Cancel ends it.</source>
        <translation>Was geschrieben wird, läuft weiter: Nur Abbrechen beendet es.</translation>
    </message>
</context>
<context>
    <name>codewheel::PageHead</name>
    <message>
        <source>Back to the monitors (Esc, Ctrl+W)</source>
        <translation>Zurück zu den Monitoren (Esc, Strg+W)</translation>
    </message>
    <message>
        <source>Close</source>
        <comment>a page</comment>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this page?</source>
        <translation>Diese Seite schließen?</translation>
    </message>
    <message>
        <source>&amp;Close the page</source>
        <translation>Seite &amp;schließen</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Bleiben</translation>
    </message>
    <message>
        <source>What is typed there will be discarded.</source>
        <translation>Was dort eingegeben ist, wird nicht übernommen.</translation>
    </message>
</context>
<context>
    <name>codewheel::PaletteManual</name>
    <message>
        <source>The window</source>
        <translation>Das Fenster, Panels, Anordnung</translation>
    </message>
    <message>
        <source>Cams</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>Device panel</source>
        <translation>Gerät, Anschlussbelegung, LEDs</translation>
    </message>
    <message>
        <source>Dial</source>
        <translation>Zifferblatt, Geber</translation>
    </message>
    <message>
        <source>EEPROM writes</source>
        <translation>EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>Gateway, registers</source>
        <translation>Gateway, Register</translation>
    </message>
    <message>
        <source>Help, keys, support</source>
        <translation>Hilfe, Tasten, Support</translation>
    </message>
    <message>
        <source>Modes, preset, reset, factory settings</source>
        <translation>Betriebsarten, Preset, Zurücksetzen, Werkseinstellungen</translation>
    </message>
    <message>
        <source>Master, faults of the ring</source>
        <translation>Master, Störungen des Rings</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Monitors, words, bits</source>
        <translation>Monitore, Worte, Bits</translation>
    </message>
    <message>
        <source>Command palette, search</source>
        <translation>Befehlspalette, suchen</translation>
    </message>
    <message>
        <source>Parameters, read, write</source>
        <translation>Parameter, lesen, schreiben</translation>
    </message>
    <message>
        <source>Project, bus structure, offline, compare</source>
        <translation>Projekt, Busaufbau, offline, vergleichen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung, aufzeichnen</translation>
    </message>
    <message>
        <source>Replay of a recording</source>
        <translation>Wiedergabe einer Aufzeichnung</translation>
    </message>
    <message>
        <source>Commissioning report, print</source>
        <translation>Inbetriebnahmebericht, drucken</translation>
    </message>
    <message>
        <source>Sequence, handshake trace</source>
        <translation>Sequenz, Handshake-Protokoll</translation>
    </message>
    <message>
        <source>Serial line, port, search for encoders</source>
        <translation>Serielle Leitung, Anschluss, Geber suchen</translation>
    </message>
    <message>
        <source>Offer a training bus</source>
        <translation>Übungsbus anbieten, bereitstellen</translation>
    </message>
    <message>
        <source>Settings, language, appearance</source>
        <translation>Einstellungen, Sprache, Darstellung</translation>
    </message>
    <message>
        <source>Simulated line, disturbances</source>
        <translation>Simulierte Leitung, Störungen</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Training, turn shafts, cause faults</source>
        <translation>Übung, Wellen drehen, Fehler verursachen</translation>
    </message>
    <message>
        <source>Transfer, replace encoder</source>
        <translation>Übertragung, Geber ersetzen, tauschen</translation>
    </message>
    <message>
        <source>Trend, curves</source>
        <translation>Trend, Kurven</translation>
    </message>
    <message>
        <source>Parameter wizard</source>
        <translation>Parametrierassistent</translation>
    </message>
    <message>
        <source>Command line</source>
        <translation>Befehlszeile, Kommandozeile</translation>
    </message>
    <message>
        <source>Port doctor, rights, no port</source>
        <translation>Anschluss-Doktor, Zugriffsrechte, kein Anschluss</translation>
    </message>
    <message>
        <source>Who is there?, find encoders</source>
        <translation>Wer ist da?, Geber finden, suchen</translation>
    </message>
    <message>
        <source>Why is there no data?, no answer, silent</source>
        <translation>Warum kommen keine Daten?, keine Antwort, stumm</translation>
    </message>
</context>
<context>
    <name>codewheel::PaletteModel</name>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>zurzeit nicht verfügbar</translation>
    </message>
    <message>
        <source>shows it in the bus structure and its monitor</source>
        <translation>zeigt ihn im Busaufbau und seinen Monitor</translation>
    </message>
    <message>
        <source>shows it among the parameters, sends nothing</source>
        <translation>zeigt ihn bei den Parametern, sendet nichts</translation>
    </message>
    <message>
        <source>shows it among the messages</source>
        <translation>zeigt sie bei den Meldungen</translation>
    </message>
    <message>
        <source>opens the manual there</source>
        <translation>öffnet dort das Handbuch</translation>
    </message>
</context>
<context>
    <name>codewheel::Panels</name>
    <message>
        <source>Bus structure</source>
        <translation>Busaufbau</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Handshake trace</source>
        <translation>Handshake-Protokoll</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Master</translation>
    </message>
    <message>
        <source>Line terminal</source>
        <translation>Leitungsterminal</translation>
    </message>
    <message>
        <source>Serial line</source>
        <translation>Serielle Leitung</translation>
    </message>
    <message>
        <source>Shows or hides the panel &quot;%1&quot;</source>
        <translation>Blendet den Bereich „%1“ ein oder aus</translation>
    </message>
</context>
<context>
    <name>codewheel::ParameterDelegate</name>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>Wanted: %1</source>
        <translation>Gewünscht: %1</translation>
    </message>
</context>
<context>
    <name>codewheel::ParameterModel</name>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>how known, time: read 14:02</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>nur lesbar</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannt</translation>
    </message>
    <message>
        <source>Read only</source>
        <translation>Nur lesbar</translation>
    </message>
    <message>
        <source>Registers of the bus chip</source>
        <translation>Register des Busbausteins</translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, aufgeklappt</translation>
    </message>
    <message>
        <source>What the encoder reports and nobody can write</source>
        <translation>Was der Geber meldet und sich nicht schreiben lässt</translation>
    </message>
    <message>
        <source>Click, or Enter: shows the registers of the INTERBUS chip. While they are shown, Read from encoder reads them, too.</source>
        <translation>Klick oder Eingabe: zeigt die Register des INTERBUS-Bausteins. Solange sie gezeigt werden, liest „Auslesen“ sie mit.</translation>
    </message>
    <message>
        <source>set it</source>
        <translation>eintragen</translation>
    </message>
    <message>
        <source>from its label</source>
        <translation>vom Typenschild</translation>
    </message>
    <message>
        <source>%1
It can be set once the encoder is connected.</source>
        <translation>%1
Er lässt sich eintragen, sobald der Geber verbunden ist.</translation>
    </message>
    <message>
        <source>Not connected: what the encoder has is not known.</source>
        <translation>Nicht verbunden: Was der Geber hat, ist unbekannt.</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>ungelesen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>%1, closed</source>
        <translation>%1, zugeklappt</translation>
    </message>
    <message>
        <source>Click, or Enter: hides the registers</source>
        <translation>Klick oder Eingabe: klappt die Register zu</translation>
    </message>
    <message>
        <source>recorded</source>
        <comment>value</comment>
        <translation>aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>codewheel::ParameterPanel</name>
    <message>
        <source>No encoder is chosen</source>
        <translation>Kein Geber gewählt</translation>
    </message>
    <message>
        <source>Choose an encoder in the bus structure. Its parameters are shown here: what it has, and what you want it to have.</source>
        <translation>Einen Geber im Busaufbau wählen. Hier stehen seine Parameter: was er hat und was er haben soll.</translation>
    </message>
    <message>
        <source>&amp;Read from encoder</source>
        <translation>Aus&amp;lesen</translation>
    </message>
    <message>
        <source>Shows what will be written before anything is sent</source>
        <translation>Zeigt, was geschrieben wird, bevor etwas gesendet wird</translation>
    </message>
    <message>
        <source>Sets the encoder up step by step</source>
        <translation>Richtet den Geber Schritt für Schritt ein</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>Mehr zu den Parametern</translation>
    </message>
    <message>
        <source>Take &amp;known values as wanted</source>
        <translation>&amp;Bekannte Werte als gewünschte übernehmen</translation>
    </message>
    <message>
        <source>&amp;Leave all unchanged</source>
        <translation>Alle &amp;unverändert lassen</translation>
    </message>
    <message>
        <source>The %1 has no read-out. Only what was written from here, or set manually, is known.</source>
        <translation>Der Geber %1 kennt kein Auslesen. Bekannt ist, was von hier geschrieben oder von Hand eingetragen wurde.</translation>
    </message>
    <message>
        <source>1 value differs</source>
        <translation>1 Wert weicht ab</translation>
    </message>
    <message>
        <source>%1 values differ</source>
        <translation>%1 Werte weichen ab</translation>
    </message>
    <message>
        <source>No value is wanted. Enter what you want in the column &quot;Wanted&quot; first.</source>
        <translation>Kein Wert ist gewünscht. Erst einen in die Spalte „Gewünscht“ eintragen.</translation>
    </message>
    <message>
        <source>Take over, clear or set values manually; modes, preset and reset</source>
        <translation>Werte übernehmen, löschen oder eintragen; Betriebsarten, Preset und Zurücksetzen</translation>
    </message>
    <message>
        <source>%1 has no parameters here</source>
        <translation>%1 hat hier keine Parameter</translation>
    </message>
    <message>
        <source>The %1 has no OUT word. It only sends its position: nothing can be read from it or written to it.</source>
        <translation>%1 hat kein OUT-Wort und meldet nur die Position: Es lässt sich nichts auslesen und nichts schreiben.</translation>
    </message>
    <message>
        <source>No source says which words set up a %1, so none are sent. Its position is shown.</source>
        <translation>Mit welchen Worten %1 eingerichtet wird, steht in keiner Quelle; darum werden keine gesendet. Die Position wird gezeigt.</translation>
    </message>
    <message>
        <source>%1: the encoder has</source>
        <comment>parameter name</comment>
        <translation>%1: Der Geber hat</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>&amp;Set manually</source>
        <translation>&amp;Eintragen</translation>
    </message>
    <message>
        <source>The position here is to be</source>
        <translation>Die Position soll hier sein</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Not connected: nothing can be read or written. What is wanted is kept in the project.</source>
        <translation>Nicht verbunden: Es lässt sich nichts lesen oder schreiben. Was gewünscht ist, bleibt im Projekt.</translation>
    </message>
    <message>
        <source>From its papers or its label; nothing is sent</source>
        <translation>Aus seinen Unterlagen oder vom Typenschild; gesendet wird nichts</translation>
    </message>
    <message>
        <source>What the encoder is known to have is wanted from now on</source>
        <translation>Was vom Geber bekannt ist, ist ab jetzt gewünscht</translation>
    </message>
    <message>
        <source>The place where it stands becomes the position you type</source>
        <translation>Die Stelle, an der er steht, bekommt die eingetippte Position</translation>
    </message>
    <message>
        <source>Known values wanted for %1</source>
        <translation>Bekannte Werte für %1 gewünscht</translation>
    </message>
    <message>
        <source>There are no words to copy. Select parameters that can be written, and of which a value is wanted or known.</source>
        <translation>Hier gibt es keine Worte zu kopieren. Parameter wählen, die sich schreiben lassen und von denen ein Wert gewünscht oder bekannt ist.</translation>
    </message>
    <message>
        <source>&amp;Write…</source>
        <translation>&amp;Schreiben…</translation>
    </message>
    <message>
        <source>Wi&amp;zard…</source>
        <translation>Assis&amp;tent…</translation>
    </message>
    <message>
        <source>Set &amp;manually what the encoder has…</source>
        <translation>&amp;Eintragen, was der Geber hat…</translation>
    </message>
    <message>
        <source>Reading hides the position for some cycles.</source>
        <translation>Beim Auslesen fehlt die Position für einige Zyklen.</translation>
    </message>
    <message>
        <source>&amp;Set the position…</source>
        <translation>Position &amp;setzen…</translation>
    </message>
    <message>
        <source>Sets the value manually; nothing is sent. An empty field clears it.</source>
        <translation>Trägt den Wert von Hand als bekannt ein; gesendet wird nichts. Ein leeres Feld nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>This is a recording: nothing is read or written.</source>
        <translation>Dies ist eine Aufzeichnung: Es wird nichts gelesen oder geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Set…</source>
        <translation>&amp;Setzen…</translation>
    </message>
    <message>
        <source>preset, zero, zero point</source>
        <translation>Preset, nullen, Nullpunkt</translation>
    </message>
    <message>
        <source>What was being typed for encoder %1 was not taken: %2 %3.</source>
        <translation>Die angefangene Eingabe für Geber %1 wurde nicht übernommen: %2 %3.</translation>
    </message>
    <message>
        <source>%1 Done before that: %2</source>
        <comment>a sentence, sentences</comment>
        <translation>%1 Davor erledigt: %2</translation>
    </message>
</context>
<context>
    <name>codewheel::ParameterTable</name>
    <message>
        <source>Parameters of the encoder</source>
        <translation>Parameter des Gebers</translation>
    </message>
    <message>
        <source>Edits the wanted value; so does typing</source>
        <translation>Bearbeitet den gewünschten Wert; Tippen ebenso</translation>
    </message>
    <message>
        <source>Opens or closes a heading</source>
        <translation>Klappt eine Überschrift auf oder zu</translation>
    </message>
    <message>
        <source>While editing: the next wanted value, or the one before</source>
        <translation>Beim Eingeben: zum nächsten gewünschten Wert oder zum vorigen</translation>
    </message>
    <message>
        <source>Leaves the selected parameters unchanged</source>
        <translation>Lässt die gewählten Parameter unverändert</translation>
    </message>
</context>
<context>
    <name>codewheel::ParameterWizard</name>
    <message>
        <source>Cance&amp;l</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>To the previous page.</source>
        <translation>Zur vorigen Seite.</translation>
    </message>
    <message>
        <source>To the next page.</source>
        <translation>Zur nächsten Seite.</translation>
    </message>
    <message>
        <source>Sends the steps above to the encoder.</source>
        <translation>Sendet die Schritte oben an den Geber.</translation>
    </message>
    <message>
        <source>Parameter wizard %1/%2</source>
        <comment>step of steps</comment>
        <translation>Parametrierassistent %1/%2</translation>
    </message>
    <message>
        <source>Edits wanted values of the project; nothing is sent before the handshake.</source>
        <translation>Bearbeitet gewünschte Werte; vor dem Handshake wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Writes to the encoder.</source>
        <translation>Schreibt in den Geber.</translation>
    </message>
    <message>
        <source>Nothing is sent here.</source>
        <translation>Hier wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Undoes what was set here, and leaves the wizard. During a handshake it first asks in which state to leave the encoder.</source>
        <translation>Nimmt zurück, was hier eingestellt wurde, und verlässt den Assistenten. Während eines Handshakes erst nach der Frage, wie der Geber verlassen werden soll.</translation>
    </message>
    <message>
        <source>What was set in the wizard is undone: %1.</source>
        <translation>Was im Assistenten eingestellt wurde, wird zurückgenommen: %1.</translation>
    </message>
    <message>
        <source>Nothing is sent before the first step.</source>
        <translation>Vor dem ersten Schritt wird nichts gesendet.</translation>
    </message>
    <message>
        <source>The handshake is under way: until it has ended, the encoder may give no position.</source>
        <translation>Der Handshake läuft noch: Bis er beendet ist, liefert der Geber vielleicht keine Position.</translation>
    </message>
    <message>
        <source>Wizard shows it again.</source>
        <translation>Assistent zeigt ihn wieder.</translation>
    </message>
    <message>
        <source>Nothing is being sent.</source>
        <translation>Es wird nichts gesendet.</translation>
    </message>
</context>
<context>
    <name>codewheel::PlanRules</name>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Devices of this bus keep their places.</source>
        <translation>Die Geräte dieses Busses behalten ihre Plätze.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address of this bus: type one from %2 to %3.</source>
        <translation>„%1“ ist keine Adresse dieses Busses: Eine von %2 bis %3 eingeben.</translation>
    </message>
    <message>
        <source>Another device is planned at %1.</source>
        <translation>Bei %1 ist ein anderes Gerät geplant.</translation>
    </message>
    <message>
        <source>&quot;%2&quot; is planned at %1.</source>
        <translation>Bei %1 ist „%2“ geplant.</translation>
    </message>
    <message>
        <source>%1: %2 is additional: it is not configured</source>
        <translation>%1: %2 ist zusätzlich da und nicht projektiert</translation>
    </message>
    <message>
        <source>%1: configured %2 is missing</source>
        <translation>%1: %2 projektiert, fehlt</translation>
    </message>
    <message>
        <source>%1: %2, as configured</source>
        <translation>%1: %2, wie projektiert</translation>
    </message>
</context>
<context>
    <name>codewheel::PortAccess</name>
    <message>
        <source>%1 is not a serial port.</source>
        <translation>%1 ist kein serieller Anschluss.</translation>
    </message>
</context>
<context>
    <name>codewheel::PortField</name>
    <message>
        <source>serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>Neu su&amp;chen</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>Choose the adapter, or type the path of a port or a pseudo terminal</source>
        <translation>Den Adapter wählen oder den Pfad eines Anschlusses oder Pseudoterminals eintippen</translation>
    </message>
    <message>
        <source>Looks for serial ports again (Alt+R)</source>
        <translation>Sucht noch einmal nach seriellen Anschlüssen (Alt+C)</translation>
    </message>
    <message>
        <source>No serial port was found. Plug the adapter in and refresh the list, or type the path of a port.</source>
        <translation>Kein serieller Anschluss gefunden. Den Adapter einstecken und neu suchen oder den Pfad eines Anschlusses eintippen.</translation>
    </message>
</context>
<context>
    <name>codewheel::PositionInput</name>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>codewheel::PositionToSet</name>
    <message>
        <source>Sends %1 with this position; it holds at once, and costs an EEPROM write.</source>
        <translation>Sendet %1 mit dieser Position; sie gilt sofort und kostet einen EEPROM-Schreibvorgang.</translation>
    </message>
</context>
<context>
    <name>codewheel::PresetReview</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Sets the position, where the encoder stands now</source>
        <translation>Setzt die Position, wo der Geber jetzt steht</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position von %1</translation>
    </message>
    <message>
        <source>&amp;Set this position</source>
        <translation>Diese Position &amp;setzen</translation>
    </message>
    <message>
        <source>Position of %1: now %2, then %3.</source>
        <translation>Position von %1: jetzt %2, danach %3.</translation>
    </message>
</context>
<context>
    <name>codewheel::Printing</name>
    <message>
        <source>The last %1 of %2 rows.</source>
        <translation>Die letzten %1 von %2 Zeilen.</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectFile</name>
    <message>
        <source>It would have %1 MB; the largest that can be opened has %2 MB.</source>
        <translation>Sie hätte %1 MB; geöffnet werden können höchstens %2 MB.</translation>
    </message>
    <message>
        <source>It could not be opened again. %3: %4</source>
        <translation>Sie ließe sich nicht wieder öffnen. %3: %4</translation>
    </message>
    <message>
        <source>Another program has locked its folder.</source>
        <translation>Ein anderes Programm hat den Ordner gesperrt.</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectFiles</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Codewheel projects (*.codewheel)</source>
        <translation>Codewheel-Projekte (*.codewheel)</translation>
    </message>
    <message>
        <source>untitled.codewheel</source>
        <comment>file name</comment>
        <translation>unbenannt.codewheel</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>The project has changes that are not saved.</source>
        <translation>Das Projekt hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>The last one: %1.</source>
        <translation>Die letzte: %1.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Saves the project, then goes on</source>
        <translation>Speichert das Projekt und macht dann weiter</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Goes on; what was changed is lost</source>
        <translation>Macht weiter; die Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>%1 no longer holds what was read or saved here: another program has changed it.</source>
        <translation>%1 enthält etwas anderes, als hier gelesen oder gespeichert wurde: Ein anderes Programm hat die Datei geändert.</translation>
    </message>
    <message>
        <source>It was changed at %1. If it is replaced, the project in it is kept as %2.</source>
        <translation>Geändert: %1. Wird die Datei ersetzt, bleibt das Projekt darin als %2 erhalten.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Saves the project in another file; this one stays unchanged</source>
        <translation>Speichert das Projekt in einer anderen Datei; diese bleibt unverändert</translation>
    </message>
    <message>
        <source>Saves the project in place of what is in the file</source>
        <translation>Speichert das Projekt anstelle dessen, was die Datei enthält</translation>
    </message>
    <message>
        <source>Others are connected to this program. Go on?</source>
        <translation>Andere sind mit diesem Programm verbunden. Weitermachen?</translation>
    </message>
    <message>
        <source>&amp;Disconnect them</source>
        <translation>Sie &amp;trennen</translation>
    </message>
    <message>
        <source>Ends what is offered, and goes on</source>
        <translation>Beendet das Angebot und macht weiter</translation>
    </message>
    <message>
        <source>What is planned for %1 is in no file: the project has no device there. Compare (F9), take it into the project, then save.</source>
        <translation>Was für %1 geplant ist, steht in keiner Datei: Das Projekt hat dort kein Gerät. Vergleichen (F9), ins Projekt übernehmen, dann speichern.</translation>
    </message>
    <message>
        <source>The project %1 was closed: the training bus has its own. File &gt; Recent files opens it again.</source>
        <translation>Das Projekt %1 wurde geschlossen: Der Übungsbus hat sein eigenes. Datei &gt; Zuletzt benutzt öffnet es wieder.</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectPage</name>
    <message>
        <source>Title of the project</source>
        <translation>Titel des Projekts</translation>
    </message>
    <message>
        <source>Crane 1</source>
        <translation>Kran 1</translation>
    </message>
    <message>
        <source>Note on the project</source>
        <translation>Notiz zum Projekt</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Note</source>
        <translation>&amp;Notiz</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>B&amp;uses</source>
        <translation>B&amp;usse</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>The heading of the commissioning report</source>
        <translation>Steht über dem Inbetriebnahmebericht</translation>
    </message>
    <message>
        <source>What the next person to open the project should know</source>
        <translation>Hinweise für den, der das Projekt als Nächstes öffnet</translation>
    </message>
    <message>
        <source>Edits title and note of the project, and its list of buses. Nothing is sent here.</source>
        <translation>Bearbeitet Angaben und Busse des Projekts. Hier wird nichts gesendet.</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectReader</name>
    <message>
        <source>This is not a project: the format is not &quot;%1&quot;.</source>
        <translation>Das ist kein Projekt: Das Format ist nicht „%1“.</translation>
    </message>
    <message>
        <source>A whole number from 1 is expected here.</source>
        <translation>Hier wird eine ganze Zahl ab 1 erwartet.</translation>
    </message>
    <message>
        <source>A device code has at most four digits, such as &quot;0237h&quot;.</source>
        <translation>Ein Gerätecode hat höchstens vier Ziffern, etwa &quot;0237h&quot;.</translation>
    </message>
    <message>
        <source>A time such as &quot;2026-03-01T14:02:00.000Z&quot; is expected here (UTC).</source>
        <translation>Hier wird eine Zeit wie &quot;2026-03-01T14:02:00.000Z&quot; erwartet (UTC).</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;.</source>
        <translation>Es gibt keinen Parameter „%1“.</translation>
    </message>
    <message>
        <source>A number of USB has at most four digits, such as &quot;0403h&quot;.</source>
        <translation>Eine USB-Nummer hat höchstens vier Ziffern, etwa &quot;0403h&quot;.</translation>
    </message>
    <message>
        <source>An address from &quot;esc:01&quot; to &quot;esc:1F&quot; is expected here, or &quot;esc:00&quot; for an encoder that is alone on its line.</source>
        <translation>Hier wird eine Adresse von &quot;esc:01&quot; bis &quot;esc:1F&quot; erwartet, oder &quot;esc:00&quot; für einen Geber, der allein an seiner Leitung ist.</translation>
    </message>
    <message>
        <source>Another bus above has the number %1.</source>
        <translation>Ein anderer Bus weiter oben hat die Nummer %1.</translation>
    </message>
    <message>
        <source>Another bus above is called &quot;%1&quot;.</source>
        <translation>Ein anderer Bus weiter oben heißt „%1“.</translation>
    </message>
    <message>
        <source>A bus needs a name, such as &quot;Ring&quot;.</source>
        <translation>Ein Bus braucht einen Namen, etwa „Ring“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be here: by its place in the list this device is %2 on the remote bus, or %3 on a local bus.</source>
        <translation>„%1“ kann hier nicht stehen: Nach seinem Platz in der Liste ist dieser Teilnehmer %2 am Fernbus oder %3 an einem Lokalbus.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is already given above.</source>
        <translation>Der Parameter „%1“ steht schon weiter oben.</translation>
    </message>
    <message>
        <source>The address &quot;%1&quot; is already given above.</source>
        <translation>Die Adresse „%1“ steht schon weiter oben.</translation>
    </message>
    <message>
        <source>Every encoder answers to &quot;esc:00&quot;: one that is there must be alone on its line.</source>
        <translation>Auf &quot;esc:00&quot; antwortet jeder Geber: Einer, der dort steht, muss allein an seiner Leitung sein.</translation>
    </message>
    <message>
        <source>The name of a bus has no &quot;/&quot;, which separates it from the place of a device.</source>
        <translation>Der Name eines Busses darf kein „/“ enthalten: Es steht zwischen ihm und dem Platz eines Teilnehmers.</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectRecovery</name>
    <message>
        <source>a project that was never saved</source>
        <translation>einem nie gespeicherten Projekt</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Codewheel ended unexpectedly. Changes of %1 are kept as of %2.</source>
        <translation>Codewheel wurde unerwartet beendet. Die Änderungen an %1 sind erhalten, Stand: %2.</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectSequences</name>
    <message>
        <source>Sequence of the project</source>
        <translation>Sequenz des Projekts</translation>
    </message>
    <message>
        <source>Chooses a sequence of the project; type to give it another name</source>
        <translation>Wählt eine Sequenz des Projekts; tippen, um sie umzubenennen</translation>
    </message>
    <message>
        <source>New sequence</source>
        <translation>Neue Sequenz</translation>
    </message>
    <message>
        <source>Begins another sequence</source>
        <translation>Beginnt eine weitere Sequenz</translation>
    </message>
    <message>
        <source>Remove the sequence</source>
        <translation>Sequenz entfernen</translation>
    </message>
    <message>
        <source>Removes this sequence from the project; can be undone</source>
        <translation>Entfernt diese Sequenz aus dem Projekt; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Se&amp;quence</source>
        <translation>Se&amp;quenz</translation>
    </message>
    <message>
        <source>Edit the sequence</source>
        <translation>Sequenz ändern</translation>
    </message>
    <message>
        <source>Name the sequence</source>
        <translation>Sequenz benennen</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>Sequenz %1</translation>
    </message>
</context>
<context>
    <name>codewheel::ProjectStep</name>
    <message>
        <source>Change of %1</source>
        <comment>a device</comment>
        <translation>Änderung an %1</translation>
    </message>
    <message>
        <source>Earlier change</source>
        <translation>Frühere Änderung</translation>
    </message>
</context>
<context>
    <name>codewheel::RecentList</name>
    <message>
        <source>it is not there any more</source>
        <translation>nicht mehr vorhanden</translation>
    </message>
    <message>
        <source>it may not be read</source>
        <translation>darf nicht gelesen werden</translation>
    </message>
    <message>
        <source>its folder does not answer</source>
        <translation>der Ordner antwortet nicht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Copy path</source>
        <translation>Pfad &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Remove from the list</source>
        <translation>Aus der &amp;Liste nehmen</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingDetails</name>
    <message>
        <source>waits for: %1</source>
        <comment>trigger</comment>
        <translation>wartet auf: %1</translation>
    </message>
    <message>
        <source>records; no encoder shows anything as yet</source>
        <translation>zeichnet auf; noch zeigt kein Geber etwas</translation>
    </message>
    <message>
        <source>records until it is ended</source>
        <translation>zeichnet auf, bis sie beendet wird</translation>
    </message>
    <message>
        <source>records until %1</source>
        <translation>zeichnet auf bis %1</translation>
    </message>
    <message>
        <source>all encoders</source>
        <translation>alle Geber</translation>
    </message>
    <message>
        <source>%1, with requests and answers</source>
        <comment>encoders</comment>
        <translation>%1, mit Anfragen und Antworten</translation>
    </message>
    <message>
        <source>%1, without requests and answers</source>
        <comment>encoders</comment>
        <translation>%1, ohne Anfragen und Antworten</translation>
    </message>
    <message>
        <source>at most %1</source>
        <comment>size</comment>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>only the last %1</source>
        <comment>duration</comment>
        <translation>nur die letzten %1</translation>
    </message>
    <message>
        <source>not known as yet</source>
        <translation>noch nicht bekannt</translation>
    </message>
    <message>
        <source>largest size in %1, then the oldest gives way</source>
        <translation>größter Umfang in %1, dann weicht das Älteste</translation>
    </message>
    <message>
        <source>never: the oldest gives way before</source>
        <translation>nie: Vorher weicht das Älteste</translation>
    </message>
    <message>
        <source>disk full in %1</source>
        <translation>Datenträger voll in %1</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What happens now: comes into the recording, and into the trend (Return)</source>
        <translation>Was jetzt geschieht: kommt in die Aufzeichnung und in den Trend (Eingabetaste)</translation>
    </message>
    <message>
        <source>&amp;Add note</source>
        <translation>&amp;Notiz setzen</translation>
    </message>
    <message>
        <source>Puts the note at this moment (Return)</source>
        <translation>Setzt die Notiz an diesen Zeitpunkt (Eingabetaste)</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>What happens now</source>
        <translation>Was jetzt geschieht</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>Free on the disk</source>
        <translation>Frei auf dem Datenträger</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>Lost values</source>
        <translation>Verlorene Werte</translation>
    </message>
    <message>
        <source>&amp;Record now</source>
        <translation>&amp;Jetzt aufzeichnen</translation>
    </message>
    <message>
        <source>Begins without waiting any longer for the trigger</source>
        <translation>Beginnt, ohne länger auf den Auslöser zu warten</translation>
    </message>
    <message>
        <source>&amp;End recording</source>
        <translation>Aufzeichnung &amp;beenden</translation>
    </message>
    <message>
        <source>Writes what has come, and closes the file</source>
        <translation>Schreibt, was gekommen ist, und schließt die Datei</translation>
    </message>
    <message>
        <source>The recording goes on (Esc)</source>
        <translation>Die Aufzeichnung geht weiter (Esc)</translation>
    </message>
    <message>
        <source>%1, for %2</source>
        <comment>date and time, duration</comment>
        <translation>%1, %2 lang</translation>
    </message>
    <message>
        <source>%1, of which %2 stay free</source>
        <comment>sizes</comment>
        <translation>%1, davon bleiben %2 frei</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>This recording runs already. End it before you begin another one.</source>
        <translation>Diese Aufzeichnung läuft schon. Vor dem Beginn einer anderen ist sie zu beenden.</translation>
    </message>
    <message>
        <source>%1 What comes meanwhile is kept in memory, as far as there is room, and written once that is over.</source>
        <translation>%1 Was inzwischen kommt, wird im Speicher gehalten, soweit Platz ist, und danach geschrieben.</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingDialog</name>
    <message>
        <source> MB</source>
        <comment>megabytes</comment>
        <translation> MB</translation>
    </message>
    <message>
        <source>&amp;Requests, answers and words as they pass</source>
        <translation>Anf&amp;ragen, Antworten und Worte, wie sie durchgehen</translation>
    </message>
    <message>
        <source>What the trace and the terminal show; on a serial line it needs the most room</source>
        <translation>Was Handshake-Protokoll und Terminal zeigen; an einer seriellen Leitung braucht das am meisten Platz</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>What was shown before that is recorded too, as far as the trend keeps it</source>
        <translation>Auch was vorher gezeigt wurde, wird aufgezeichnet, soweit der Trend es aufbewahrt</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Endet</translation>
    </message>
    <message>
        <source>By hand, or after a time</source>
        <translation>Von Hand oder nach einer Zeit</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>From the beginning, or from the trigger</source>
        <translation>Vom Beginn oder vom Auslöser an</translation>
    </message>
    <message>
        <source>Only the &amp;last</source>
        <translation>Nur die &amp;letzten</translation>
    </message>
    <message>
        <source>What is older gives way to what comes</source>
        <translation>Was älter ist, weicht dem, was kommt</translation>
    </message>
    <message>
        <source>Only the last</source>
        <translation>Nur die letzten</translation>
    </message>
    <message>
        <source>How far back the recording goes</source>
        <translation>Wie weit die Aufzeichnung zurückreicht</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>&amp;Höchstens</translation>
    </message>
    <message>
        <source>Once it is that large, the oldest gives way to what comes</source>
        <translation>Ist sie so groß, weicht das Älteste dem, was kommt</translation>
    </message>
    <message>
        <source>Largest size</source>
        <translation>Größter Umfang</translation>
    </message>
    <message>
        <source>How large the file becomes</source>
        <translation>Wie groß die Datei wird</translation>
    </message>
    <message>
        <source>Leave free</source>
        <translation>Frei lassen</translation>
    </message>
    <message>
        <source>So much of the disk is left to others; the recording waits where there is less</source>
        <translation>So viel vom Datenträger bleibt anderen; ist weniger frei, wartet die Aufzeichnung</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>when it is ended by hand</source>
        <translation>wenn sie von Hand beendet wird</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nach</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>Date&amp;i</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>&amp;Begins</source>
        <translation>&amp;Beginnt</translation>
    </message>
    <message>
        <source>B&amp;efore</source>
        <translation>Da&amp;vor</translation>
    </message>
    <message>
        <source>E&amp;nds</source>
        <translation>&amp;Endet</translation>
    </message>
    <message>
        <source>Lea&amp;ve free</source>
        <translation>&amp;Frei lassen</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>Auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>Makes the file, and begins or waits for the trigger; sends nothing</source>
        <translation>Legt die Datei an und beginnt oder wartet auf den Auslöser; sendet nichts</translation>
    </message>
    <message>
        <source>Records nothing (Esc)</source>
        <translation>Zeichnet nichts auf (Esc)</translation>
    </message>
    <message>
        <source>Tick the encoders that are to be recorded, or choose all.</source>
        <translation>Die Geber ankreuzen, die aufgezeichnet werden sollen, oder alle wählen.</translation>
    </message>
    <message>
        <source>No encoder is there that could begin the recording: connect one first, or let it begin at once.</source>
        <translation>Es ist kein Geber da, der die Aufzeichnung auslösen könnte: erst einen verbinden oder sofort beginnen lassen.</translation>
    </message>
    <message>
        <source>Say how long it is to record.</source>
        <translation>Angeben, wie lange aufgezeichnet werden soll.</translation>
    </message>
    <message>
        <source>Say how far back it is to go.</source>
        <translation>Angeben, wie weit sie zurückreichen soll.</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingFileField</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The file of the recording; it must not be there yet</source>
        <translation>Die Datei der Aufzeichnung; es darf sie noch nicht geben</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Asks for folder and name of the file</source>
        <translation>Fragt nach Ordner und Name der Datei</translation>
    </message>
    <message>
        <source>Name a file.</source>
        <translation>Eine Datei angeben.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>Nothing may be saved in the folder %1.</source>
        <translation>Im Ordner %1 darf nichts gespeichert werden.</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Datei der Aufzeichnung</translation>
    </message>
    <message>
        <source>Recordings (*.cwrec)</source>
        <translation>Aufzeichnungen (*.cwrec)</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingInWindow</name>
    <message>
        <source>The recording has ended: %1, %2.</source>
        <translation>Die Aufzeichnung ist beendet: %1, %2.</translation>
    </message>
    <message>
        <source>Quit Codewheel</source>
        <translation>Codewheel beenden</translation>
    </message>
    <message>
        <source>A recording waits for its trigger.</source>
        <translation>Eine Aufzeichnung wartet auf ihren Auslöser.</translation>
    </message>
    <message>
        <source>A recording runs.</source>
        <translation>Eine Aufzeichnung läuft.</translation>
    </message>
    <message>
        <source>It goes to %1. What has come so far is written there before the program ends.</source>
        <translation>Sie geht nach %1. Was bisher gekommen ist, wird dort geschrieben, bevor das Programm endet.</translation>
    </message>
    <message>
        <source>&amp;End it and quit</source>
        <translation>&amp;Aufzeichnung und Programm beenden</translation>
    </message>
    <message>
        <source>Ends the recording, then goes on quitting</source>
        <translation>Beendet die Aufzeichnung, dann das Programm</translation>
    </message>
    <message>
        <source>&amp;Go on recording</source>
        <translation>&amp;Weiter aufzeichnen</translation>
    </message>
    <message>
        <source>The window stays open (Esc)</source>
        <translation>Das Fenster bleibt offen (Esc)</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingIndicator</name>
    <message>
        <source>%1
Shows more about the recording</source>
        <comment>file, or what is wrong</comment>
        <translation>%1
Zeigt mehr über die Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording held up</source>
        <translation>Aufzeichnung stockt</translation>
    </message>
    <message>
        <source>Waits for its trigger</source>
        <translation>Wartet auf Auslöser</translation>
    </message>
    <message>
        <source>Records %1, %2</source>
        <comment>time, size</comment>
        <translation>Zeichnet auf: %1, %2</translation>
    </message>
</context>
<context>
    <name>codewheel::RecordingTexts</name>
    <message>
        <source>At the present rate %1 need about %2: the disk does not get full.</source>
        <translation>Geht es so weiter, brauchen %1 etwa %2: Der Datenträger wird nicht voll.</translation>
    </message>
    <message>
        <source>At the present rate, about %1 an hour, it has its largest size after %2; from then on the oldest gives way.</source>
        <translation>Geht es so weiter, etwa %1 in der Stunde, ist nach %2 der größte Umfang erreicht; von da an weicht das Älteste.</translation>
    </message>
    <message>
        <source>At the present rate, about %1 an hour, that is enough for %2.</source>
        <translation>Geht es so weiter, etwa %1 in der Stunde, reicht das für %2.</translation>
    </message>
    <message>
        <source>%1: %2 becomes 1</source>
        <comment>place, bit</comment>
        <translation>%1: %2 wird 1</translation>
    </message>
    <message>
        <source>%1: %2 becomes 0</source>
        <comment>place, bit</comment>
        <translation>%1: %2 wird 0</translation>
    </message>
    <message>
        <source>%1: %2 rises to %3</source>
        <comment>place, value, number with unit</comment>
        <translation>%1: %2 steigt auf %3</translation>
    </message>
    <message>
        <source>%1: %2 falls below %3</source>
        <comment>place, value, number with unit</comment>
        <translation>%1: %2 fällt unter %3</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>eine Störung</translation>
    </message>
    <message>
        <source>a message of attention, or a fault</source>
        <translation>eine Meldung „Achtung“ oder eine Störung</translation>
    </message>
    <message>
        <source>a message</source>
        <translation>eine Meldung</translation>
    </message>
    <message>
        <source>Free on this disk: %1.</source>
        <translation>Frei auf diesem Datenträger: %1.</translation>
    </message>
    <message>
        <source>That is less than is to stay free: nothing would be written.</source>
        <translation>Das ist weniger, als frei bleiben soll: Nichts würde geschrieben.</translation>
    </message>
    <message>
        <source>How long it is enough is not known until encoders have shown something.</source>
        <translation>Wie lange das reicht, ist erst bekannt, wenn Geber etwas gezeigt haben.</translation>
    </message>
    <message>
        <source>Nothing changes at present, so next to nothing is needed.</source>
        <translation>Zurzeit ändert sich nichts, also wird so gut wie nichts gebraucht.</translation>
    </message>
</context>
<context>
    <name>codewheel::RegistersPage</name>
    <message>
        <source>Registers of the devices</source>
        <translation>Register der Teilnehmer</translation>
    </message>
    <message>
        <source>The IN word of each device in the four orders. Bold: as it is read now</source>
        <translation>Das IN-Wort jedes Teilnehmers in den vier Reihenfolgen. Fett: wie es jetzt gelesen wird</translation>
    </message>
    <message>
        <source>Read &amp;now</source>
        <translation>&amp;Jetzt lesen</translation>
    </message>
    <message>
        <source>Only reads. The word order is kept in the project.</source>
        <translation>Liest nur. Die Wortreihenfolge steht im Projekt.</translation>
    </message>
    <message>
        <source>What the registers show can only be low word first.</source>
        <translation>Was die Register zeigen, kann nur „unteres Wort zuerst“ sein.</translation>
    </message>
    <message>
        <source>What the registers show can only be high word first.</source>
        <translation>Was die Register zeigen, kann nur „oberes Wort zuerst“ sein.</translation>
    </message>
    <message>
        <source>Set low word first</source>
        <translation>Unteres Wort zuerst einstellen</translation>
    </message>
    <message>
        <source>Set high word first</source>
        <translation>Oberes Wort zuerst einstellen</translation>
    </message>
    <message>
        <source>&amp;Set low word first</source>
        <translation>Unteres Wort zuerst ein&amp;stellen</translation>
    </message>
    <message>
        <source>&amp;Set high word first</source>
        <translation>Oberes Wort zuerst ein&amp;stellen</translation>
    </message>
    <message>
        <source>For IN and OUT of all devices, kept in the project. A bus that is connected is connected anew, in Watch (Alt+S)</source>
        <translation>Für IN und OUT aller Teilnehmer, im Projekt. Ein verbundener Bus wird neu verbunden, auf Beobachten (Alt+S)</translation>
    </message>
    <message>
        <source>The bus is connected: what is shown is read with each exchange</source>
        <translation>Der Bus ist verbunden: Was hier steht, wird mit jedem Austausch gelesen</translation>
    </message>
    <message>
        <source>Connects to the gateway, reads the registers of the chosen device, and disconnects (Alt+N)</source>
        <translation>Verbindet mit dem Gateway, liest die Register des gewählten Teilnehmers und trennt wieder (Alt+J)</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplaceAccountStep</name>
    <message>
        <source>What was written</source>
        <translation>Was geschrieben wurde</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>The position was set to %1 all the same.</source>
        <translation>Die Position wurde trotzdem auf %1 gesetzt.</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplaceDeviceStep</name>
    <message>
        <source>New encoder</source>
        <translation>Neuer Geber</translation>
    </message>
    <message>
        <source>Key on the label of the new encoder</source>
        <translation>Schlüssel auf dem Typenschild des neuen Gebers</translation>
    </message>
    <message>
        <source>Type the key on the label. Spaces, dots and dashes do not matter.</source>
        <translation>Den Schlüssel vom Typenschild eintippen. Leerzeichen, Punkte und Striche spielen keine Rolle.</translation>
    </message>
    <message>
        <source>Serial number of the new encoder</source>
        <translation>Seriennummer des neuen Gebers</translation>
    </message>
    <message>
        <source>From its label; EEPROM writes are counted by it where the encoder does not report one</source>
        <translation>Vom Typenschild; nach ihr werden EEPROM-Schreibvorgänge gezählt, wo der Geber sie nicht meldet</translation>
    </message>
    <message>
        <source>&amp;Label key</source>
        <translation>&amp;Typenschlüssel</translation>
    </message>
    <message>
        <source>Enc&amp;oder</source>
        <translation>Gebe&amp;r</translation>
    </message>
    <message>
        <source>&amp;Serial number</source>
        <translation>&amp;Seriennummer</translation>
    </message>
    <message>
        <source>At %1 the project has: %2%3. Switch the supply off, replace the encoder, and switch it on again.</source>
        <translation>Bei %1 hat das Projekt: %2%3. Versorgung abschalten, den Geber ersetzen und wieder einschalten.</translation>
    </message>
    <message>
        <source>, serial number %1</source>
        <translation>, Seriennummer %1</translation>
    </message>
    <message>
        <source>The catalog has no encoder for this place.</source>
        <translation>Der Katalog hat keinen Geber für diesen Platz.</translation>
    </message>
    <message>
        <source>The key is not that of the chosen encoder. Choose the encoder of the label, or clear the key.</source>
        <translation>Der Schlüssel gehört nicht zum gewählten Geber. Den Geber vom Typenschild wählen oder den Schlüssel löschen.</translation>
    </message>
    <message>
        <source>It fits: as far as the project shows, it is like the previous one.</source>
        <translation>Er passt: Soweit aus dem Projekt bekannt, ist er wie der vorige.</translation>
    </message>
    <message>
        <source>The encoders of the catalog that fit this place</source>
        <translation>Die Geber des Katalogs, die auf diesem Platz stehen können</translation>
    </message>
    <message>
        <source>The project does not say which encoder was here before: whether this one is like it is not known. Compare the labels.</source>
        <translation>Das Projekt sagt nicht, welcher Geber vorher hier war: Ob dieser ihm gleicht, ist nicht bekannt. Die Typenschilder vergleichen.</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplacePage</name>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Replace encoder</source>
        <translation>Geber ersetzen</translation>
    </message>
    <message>
        <source>To the previous step</source>
        <translation>Zum vorigen Schritt</translation>
    </message>
    <message>
        <source>Replace encoder %1</source>
        <translation>Geber %1 ersetzen</translation>
    </message>
    <message>
        <source>Back to the monitors</source>
        <translation>Zurück zu den Monitoren</translation>
    </message>
    <message>
        <source>To the next step</source>
        <translation>Zum nächsten Schritt</translation>
    </message>
    <message>
        <source>Sends what is shown above to the new encoder</source>
        <translation>Sendet das oben Gezeigte an den neuen Geber</translation>
    </message>
    <message>
        <source>Replace encoder %1/%2</source>
        <comment>step of steps</comment>
        <translation>Geber ersetzen %1/%2</translation>
    </message>
    <message>
        <source>What was written. Nothing more is sent.</source>
        <translation>Was geschrieben wurde. Es wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>Writes to the encoder.</source>
        <translation>Schreibt in den Geber.</translation>
    </message>
    <message>
        <source>Nothing is sent or planned before Write.</source>
        <translation>Vor „Schreiben“ wird nichts gesendet und nichts geplant.</translation>
    </message>
    <message>
        <source>Nothing has been written to %1, and what was given here is forgotten.</source>
        <translation>In %1 wurde nichts geschrieben; was hier angegeben wurde, geht verloren.</translation>
    </message>
    <message>
        <source>The bus of %1 is starting. Once it runs, this begins anew, with what was given of the new encoder.</source>
        <translation>Der Bus von %1 startet. Sobald er läuft, beginnt dies von vorn, mit dem, was zum neuen Geber eingegeben war.</translation>
    </message>
    <message>
        <source>Ends here; nothing is written</source>
        <translation>Endet hier; nichts wird geschrieben</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplacePositionStep</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>&amp;Set the position to</source>
        <translation>Position &amp;setzen auf</translation>
    </message>
    <message>
        <source>&amp;Leave the position as the new encoder shows it</source>
        <translation>Position &amp;lassen, wie der neue Geber sie zeigt</translation>
    </message>
    <message>
        <source>The position that was seen last, and when</source>
        <translation>Die zuletzt gesehene Position, und wann</translation>
    </message>
    <message>
        <source>Nothing is set: the machine has to be referenced another way</source>
        <translation>Nichts wird gesetzt: Die Maschine muss anders referenziert werden</translation>
    </message>
    <message>
        <source>Position in steps</source>
        <translation>Position in Schritten</translation>
    </message>
    <message>
        <source>Position in steps, decimal or hexadecimal (0x.. or ..h)</source>
        <translation>Position in Schritten, dezimal oder hexadezimal (0x.. oder ..h)</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>&amp;Position %1, seen at %2, before the encoder went away</source>
        <translation>&amp;Position %1, gesehen um %2, bevor der Geber verschwand</translation>
    </message>
    <message>
        <source>Position kept in the pro&amp;ject</source>
        <translation>Im Pro&amp;jekt aufbewahrte Position</translation>
    </message>
    <message>
        <source>Position %1, kept in the pro&amp;ject: seen at %2</source>
        <translation>Position %1, im Pro&amp;jekt aufbewahrt: gesehen am %2</translation>
    </message>
    <message>
        <source>&amp;Position %1, shown at %2; not away since</source>
        <translation>&amp;Position %1, gezeigt um %2; seitdem ununterbrochen da</translation>
    </message>
    <message>
        <source>&amp;Position of the previous encoder</source>
        <translation>&amp;Position des vorigen Gebers</translation>
    </message>
    <message>
        <source>The shaft must stand where it stood then. The zero offset of the previous encoder is not written: setting the position makes a new one. A preset that the project wants is written last, and does not act by itself.</source>
        <translation>Die Welle muss stehen, wo sie damals stand. Die Nullpunkt-Verschiebung des vorigen Gebers wird nicht geschrieben: Das Setzen der Position ergibt eine neue. Ein Preset, den das Projekt wünscht, wird zuletzt geschrieben und wirkt nicht von selbst.</translation>
    </message>
    <message>
        <source>From your notes, or from where the machine stands</source>
        <translation>Aus Notizen oder nach dem Stand der Maschine</translation>
    </message>
    <message>
        <source>Give the position as a whole number, 0 or more, or leave it unchanged.</source>
        <translation>Die Position als ganze Zahl ab 0 angeben oder unverändert lassen.</translation>
    </message>
    <message>
        <source>The last position of the previous encoder when the project was saved</source>
        <translation>Die Position, die der vorige Geber zuletzt zeigte, als das Projekt gespeichert wurde</translation>
    </message>
    <message>
        <source>The encoder has not been away since: it may still be the previous one</source>
        <translation>Der Geber war seitdem ununterbrochen da: Es kann noch der vorige sein</translation>
    </message>
    <message>
        <source>The last position of the previous encoder</source>
        <translation>Die Position, die der vorige Geber zuletzt zeigte</translation>
    </message>
    <message>
        <source>&amp;Position %1, seen at %2. Then nobody saw the encoder for a while; it was not seen to be away.</source>
        <translation>&amp;Position %1, gesehen um %2. Danach hat eine Weile niemand den Geber gesehen; dass er weg war, wurde nicht gesehen.</translation>
    </message>
    <message>
        <source>%1 The encoder was scaled otherwise then: now this is another position.</source>
        <comment>a sentence, or most of one</comment>
        <translation>%1 Der Geber war damals anders skaliert: Jetzt ist das eine andere Position.</translation>
    </message>
    <message>
        <source>The computer slept, or the bus was stopped or lost: the encoder may still be the previous one</source>
        <translation>Der Rechner war im Ruhezustand, oder der Bus war angehalten oder nicht erreichbar: Es kann noch der bisherige Geber sein</translation>
    </message>
    <message>
        <source>Position since &amp;then</source>
        <translation>Position &amp;seitdem</translation>
    </message>
    <message>
        <source>The last position that was seen: right if the encoder that came back is the previous one, and not the new one</source>
        <translation>Die zuletzt gesehene Position: richtig, wenn der Geber, der wiederkam, noch der alte ist und nicht der neue</translation>
    </message>
    <message>
        <source>Position %1, shown since &amp;then, at %2 last: of the previous encoder only if the one that came back is not the new one</source>
        <translation>Position %1, &amp;seitdem gezeigt, zuletzt um %2: nur dann die des alten Gebers, wenn der, der wiederkam, nicht der neue ist</translation>
    </message>
    <message>
        <source>%1 It is of another scale than the wanted one: with that, it is another position.</source>
        <comment>a sentence, or most of one</comment>
        <translation>%1 Sie hat eine andere Skalierung als die gewünschte: Mit dieser ist sie eine andere Position.</translation>
    </message>
    <message>
        <source>%1 Since then values of its scale, or its position, were written here: it is right if the previous encoder had the same scale.</source>
        <comment>a sentence, or most of one</comment>
        <translation>%1 Seitdem wurde hier etwas an der Skalierung oder die Position geschrieben: Sie stimmt, wenn der vorherige Geber dieselbe Skalierung hatte.</translation>
    </message>
    <message>
        <source>Other values are wanted than when the position was chosen: with them it may be another place. Choose it once more.</source>
        <translation>Es sind andere Werte gewünscht als bei der Wahl der Position: Mit ihnen kann sie eine andere Stelle sein. Bitte noch einmal wählen.</translation>
    </message>
    <message>
        <source>%1. How the encoder was scaled then is not known: it is right if its scale was the same.</source>
        <comment>most of a sentence</comment>
        <translation>%1. Wie der Geber damals skaliert war, ist nicht bekannt: Sie stimmt, wenn seine Skalierung dieselbe war.</translation>
    </message>
    <message>
        <source>%1. How the encoder was scaled then is not known in full: it is right if all of its scale was the same.</source>
        <comment>most of a sentence</comment>
        <translation>%1. Wie der Geber damals skaliert war, ist nicht ganz bekannt: Sie stimmt, wenn seine ganze Skalierung dieselbe war.</translation>
    </message>
    <message>
        <source>The bus was stopped or the encoder was away since the position was chosen. Choose it once more.</source>
        <translation>Seit die Position gewählt wurde, war der Bus angehalten oder der Geber weg. Bitte noch einmal wählen.</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplaceStep</name>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplaceWriteStep</name>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>There are no values for it, neither wanted nor stored. Write puts the new encoder into the project.</source>
        <translation>Es gibt keine Werte für ihn, weder gewünschte noch abgelegte. Schreiben nimmt den neuen Geber ins Projekt auf.</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>The project has no values for it, neither wanted nor stored: what the previous encoder had is not written.</source>
        <translation>Das Projekt hat keine Werte dafür, weder gewünschte noch gespeicherte: Was der vorige Geber hatte, wird nicht geschrieben.</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplayBar</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>Beginning</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>To the beginning of the recording</source>
        <translation>Zum Anfang der Aufzeichnung</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>Schritt zurück</translation>
    </message>
    <message>
        <source>To the previous sample of the chosen encoder</source>
        <translation>Zum vorigen Messwert des gewählten Gebers</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Plays the recording backward</source>
        <translation>Spielt die Aufzeichnung rückwärts ab</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stands still</source>
        <translation>Bleibt stehen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plays the recording forward</source>
        <translation>Spielt die Aufzeichnung vorwärts ab</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>To the next sample of the chosen encoder</source>
        <translation>Zum nächsten Messwert des gewählten Gebers</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>To the end of the recording</source>
        <translation>Zum Ende der Aufzeichnung</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the recording</source>
        <translation>Schließt die Aufzeichnung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>When what is shown was recorded</source>
        <translation>Wann das Gezeigte aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>How fast the recording is played (Ctrl+Alt++: faster, Ctrl+Alt+-: slower)</source>
        <translation>Wie schnell die Aufzeichnung abgespielt wird (Strg+Alt++: schneller, Strg+Alt+-: langsamer)</translation>
    </message>
    <message>
        <source>Message of then</source>
        <translation>Meldung von damals</translation>
    </message>
    <message>
        <source>What the program said when this was recorded</source>
        <translation>Was das Programm bei der Aufzeichnung meldete</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplayModel</name>
    <message>
        <source>none</source>
        <comment>answer</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>not sent; writes</source>
        <translation>nicht gesendet; schreibt</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>nicht gesendet</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
    <message>
        <source>Saved answer</source>
        <translation>Aufgezeichnete Antwort</translation>
    </message>
    <message>
        <source>Answer now</source>
        <translation>Antwort jetzt</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplayOutline</name>
    <message>
        <source>Recording (%1)</source>
        <translation>Aufzeichnung (%1)</translation>
    </message>
    <message>
        <source>%1
Shown: %2
From %3 to %4
Nothing is sent.</source>
        <translation>%1
Gezeigt: %2
Von %3 bis %4
Es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>damals</translation>
    </message>
    <message>
        <source>%1  %2
State: %3 (%4)</source>
        <translation>%1  %2
Zustand: %3 (%4)</translation>
    </message>
    <message>
        <source>This program has no description of this device: only its words are shown.</source>
        <translation>Dieses Programm hat keine Beschreibung dieses Geräts: Nur seine Worte werden gezeigt.</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>nothing: it is a recording</source>
        <translation>nichts: Es ist eine Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>codewheel::ReplaySlider</name>
    <message>
        <source>Moment of the recording</source>
        <translation>Stelle der Aufzeichnung</translation>
    </message>
    <message>
        <source>Drag it to another moment of the recording. Left and Right: a hundredth of it; Page Up and Page Down: a tenth; Home and End</source>
        <translation>An eine andere Stelle der Aufzeichnung ziehen. Links und Rechts: ein Hundertstel davon; Bild auf und Bild ab: ein Zehntel; Pos1 und Ende</translation>
    </message>
</context>
<context>
    <name>codewheel::ReportExport</name>
    <message>
        <source>report</source>
        <comment>file name</comment>
        <translation>bericht</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>Save the commissioning report</source>
        <translation>Inbetriebnahmebericht speichern</translation>
    </message>
    <message>
        <source>The report was not saved: %1 ends neither in .pdf nor in .html.</source>
        <translation>Der Bericht wurde nicht gespeichert: %1 endet weder auf .pdf noch auf .html.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>No program on this computer opens %1. The report is saved.</source>
        <translation>Kein Programm dieses Rechners öffnet %1. Der Bericht ist gespeichert.</translation>
    </message>
</context>
<context>
    <name>codewheel::ReportPage</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
</context>
<context>
    <name>codewheel::ReportPreview</name>
    <message>
        <source>Sheets of the report</source>
        <translation>Blätter des Berichts</translation>
    </message>
    <message>
        <source>The report as it will be saved or printed</source>
        <translation>Der Bericht, wie er gespeichert oder gedruckt wird</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Asks where to save it, as a PDF or a web page</source>
        <translation>Fragt, wo er gespeichert wird, als PDF oder Webseite</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Dr&amp;ucken…</translation>
    </message>
    <message>
        <source>Asks for the printer</source>
        <translation>Fragt nach dem Drucker</translation>
    </message>
</context>
<context>
    <name>codewheel::ReportSheets</name>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
</context>
<context>
    <name>codewheel::ReportTexts</name>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>%1 to %2, active</source>
        <translation>%1 bis %2, aktiv</translation>
    </message>
    <message>
        <source>%1 to %2, inactive</source>
        <translation>%1 bis %2, nicht aktiv</translation>
    </message>
    <message>
        <source>as wanted</source>
        <translation>wie gewünscht</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>Cam</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannt</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>%1, the largest position of a cam; the total range is unknown</source>
        <translation>%1, die größte Position eines Nockens; der Gesamtbereich ist unbekannt</translation>
    </message>
    <message>
        <source>Cam program %1, wanted</source>
        <translation>Nockenprogramm %1, gewünscht</translation>
    </message>
    <message>
        <source>Cam program %1, as wanted, known: %2, %3</source>
        <translation>Nockenprogramm %1, wie gewünscht, bekannt: %2, %3</translation>
    </message>
    <message>
        <source>Cam program %1, known: %2, %3</source>
        <translation>Nockenprogramm %1, bekannt: %2, %3</translation>
    </message>
    <message>
        <source>Cam programs in which nothing is set: %1.</source>
        <translation>Nockenprogramme, in denen nichts gesetzt ist: %1.</translation>
    </message>
    <message>
        <source>serial number %1, read from it</source>
        <translation>Seriennummer %1, ausgelesen</translation>
    </message>
    <message>
        <source>serial number %1, from its label</source>
        <translation>Seriennummer %1, vom Typenschild</translation>
    </message>
    <message>
        <source>project and place; another encoder at this place counts on</source>
        <translation>Projekt und Platz; ein anderer Geber an diesem Platz zählt weiter</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>about %1; nothing is guaranteed beyond %2</source>
        <translation>etwa %1; über %2 hinaus wird nichts zugesichert</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>EEPROM writes by this program</source>
        <translation>EEPROM-Schreibvorgänge durch dieses Programm</translation>
    </message>
    <message>
        <source>No.</source>
        <comment>device number</comment>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>Schreibvorgänge</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Encoder identified by</source>
        <translation>Geber erkannt an</translation>
    </message>
    <message>
        <source>Writes the manual states</source>
        <translation>Schreibvorgänge laut Handbuch</translation>
    </message>
    <message>
        <source>The project has no encoder that can be written.</source>
        <translation>Das Projekt hat keinen Geber, der beschrieben werden kann.</translation>
    </message>
    <message>
        <source>What other programs and controllers wrote is not known and not counted.</source>
        <translation>Was andere Programme und Steuerungen geschrieben haben, ist nicht bekannt und nicht gezählt.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Unterschriften</translation>
    </message>
    <message>
        <source>Commissioned by</source>
        <translation>In Betrieb genommen von</translation>
    </message>
    <message>
        <source>Accepted by</source>
        <translation>Abgenommen von</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Unterschrift</translation>
    </message>
    <message>
        <source>Cam program %1: start of cam %2</source>
        <translation>Nockenprogramm %1: Anfang von Nocken %2</translation>
    </message>
    <message>
        <source>Cam program %1: stop of cam %2</source>
        <translation>Nockenprogramm %1: Ende von Nocken %2</translation>
    </message>
    <message>
        <source>Cam program %1: active cams 7 to 0</source>
        <translation>Nockenprogramm %1: aktive Nocken 7 bis 0</translation>
    </message>
    <message>
        <source>Cam program %1: shift</source>
        <translation>Nockenprogramm %1: Verschiebung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>No encoder is known to have anything other than what is wanted.</source>
        <translation>Von keinem Geber ist bekannt, dass er vom Gewünschten abweicht.</translation>
    </message>
    <message numerus="yes">
        <source>%n wanted value(s) or cam program(s) could not be compared: what the encoders have there is unknown.</source>
        <translation>
            <numerusform>%n gewünschter Wert oder Nockenprogramm ließ sich nicht vergleichen: Was die Geber dort haben, ist unbekannt.</numerusform>
            <numerusform>%n gewünschte Werte oder Nockenprogramme ließen sich nicht vergleichen: Was die Geber dort haben, ist unbekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>The configured bus was not compared with a connected one.</source>
        <translation>Der projektierte Bus wurde mit keinem angeschlossenen verglichen.</translation>
    </message>
    <message>
        <source>The connected bus is as configured.</source>
        <translation>Der angeschlossene Bus ist wie projektiert.</translation>
    </message>
    <message>
        <source>Configured and connected bus</source>
        <translation>Projektierter und angeschlossener Bus</translation>
    </message>
    <message>
        <source>Rules of the bus</source>
        <translation>Regeln des Busses</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>place, device</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>place, device, station</comment>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>%1 (from the label)</source>
        <translation>%1 (vom Typenschild)</translation>
    </message>
    <message>
        <source>%1 revolutions, %2 steps per revolution</source>
        <translation>%1 Umdrehungen, %2 Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Typenschild</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Total range</source>
        <translation>Gesamtbereich</translation>
    </message>
    <message>
        <source>%1 positions</source>
        <translation>%1 Positionen</translation>
    </message>
    <message>
        <source>Known values</source>
        <translation>Bekannte Werte</translation>
    </message>
    <message>
        <source>of the connected encoder</source>
        <translation>vom angeschlossenen Geber</translation>
    </message>
    <message>
        <source>as stored in the project; the encoder was not asked</source>
        <translation>wie im Projekt abgelegt; der Geber wurde nicht gefragt</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>It has no parameters: it only sends its position.</source>
        <translation>Er hat keine Parameter: Er meldet nur seine Position.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Date, time</source>
        <translation>Datum, Uhrzeit</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>The project has no encoders.</source>
        <translation>Das Projekt hat keine Geber.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>without a title</source>
        <translation>ohne Titel</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Teilnehmer</translation>
    </message>
    <message>
        <source>%1, encoders among them: %2</source>
        <translation>%1, davon Geber: %2</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>Inbetriebnahmebericht</translation>
    </message>
    <message>
        <source>%1 (no description of it is known)</source>
        <translation>%1 (keine Beschreibung dazu bekannt)</translation>
    </message>
    <message>
        <source>%1 by hand</source>
        <comment>address</comment>
        <translation>%1 von Hand</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>ID code</source>
        <translation>ID-Code</translation>
    </message>
    <message>
        <source>Words IN / OUT</source>
        <translation>Worte IN / OUT</translation>
    </message>
    <message>
        <source>IN from word</source>
        <translation>IN ab Wort</translation>
    </message>
    <message>
        <source>IN from byte</source>
        <translation>IN ab Byte</translation>
    </message>
    <message>
        <source>OUT from word</source>
        <translation>OUT ab Wort</translation>
    </message>
    <message>
        <source>OUT from byte</source>
        <translation>OUT ab Byte</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>about %1 ms</source>
        <translation>etwa %1 ms</translation>
    </message>
    <message>
        <source>Bus structure</source>
        <translation>Busaufbau</translation>
    </message>
    <message>
        <source>The project has no devices.</source>
        <translation>Das Projekt hat keine Teilnehmer.</translation>
    </message>
    <message>
        <source>Transmission speed</source>
        <translation>Übertragungsrate</translation>
    </message>
    <message>
        <source>Formula of G3 masters</source>
        <translation>Formel der G3-Master</translation>
    </message>
    <message>
        <source>Formula of G4 masters</source>
        <translation>Formel der G4-Master</translation>
    </message>
    <message>
        <source>500 kBd</source>
        <translation>500 kBd</translation>
    </message>
    <message>
        <source>2 MBd</source>
        <translation>2 MBd</translation>
    </message>
    <message>
        <source>Approximate cycle time</source>
        <translation>Ungefähre Zykluszeit</translation>
    </message>
    <message>
        <source>this connection only; nothing is kept of others</source>
        <translation>nur diese Verbindung; von anderen ist nichts aufbewahrt</translation>
    </message>
    <message>
        <source>not compared with a connected one</source>
        <translation>nicht mit einem angeschlossenen verglichen</translation>
    </message>
    <message>
        <source>connected as configured</source>
        <translation>angeschlossen wie projektiert</translation>
    </message>
    <message>
        <source>not connected as configured; lines that differ: %1</source>
        <translation>nicht wie projektiert angeschlossen; abweichende Zeilen: %1</translation>
    </message>
    <message>
        <source>Deviations of encoders</source>
        <translation>Abweichungen der Geber</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Bytes of process data: %1, remote bus devices: %2, km of cable: %3.</source>
        <translation>Prozessdaten in Byte: %1, Fernbusteilnehmer: %2, Kabel in km: %3.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Not compared with connected ones: %1.</source>
        <translation>Nicht mit angeschlossenen verglichen: %1.</translation>
    </message>
    <message>
        <source>%1; not compared: %2</source>
        <comment>result, names of buses</comment>
        <translation>%1; nicht verglichen: %2</translation>
    </message>
    <message>
        <source>hysteresis %1</source>
        <translation>Hysterese %1</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>invertiert</translation>
    </message>
    <message>
        <source>Cam program %1: hysteresis of cam %2</source>
        <translation>Nockenprogramm %1: Hysterese von Nocken %2</translation>
    </message>
    <message>
        <source>Cam program %1: inverted cams 7 to 0</source>
        <translation>Nockenprogramm %1: invertierte Nocken 7 bis 0</translation>
    </message>
    <message>
        <source>The connected buses are as configured.</source>
        <translation>Die angeschlossenen Busse sind wie projektiert.</translation>
    </message>
    <message>
        <source>Approximate cycle time of %1</source>
        <translation>Ungefähre Zykluszeit von %1</translation>
    </message>
    <message>
        <source>The connected buses were as configured.</source>
        <translation>Die angeschlossenen Busse waren wie projektiert.</translation>
    </message>
    <message>
        <source>The connected bus was as configured.</source>
        <translation>Der angeschlossene Bus war wie projektiert.</translation>
    </message>
    <message>
        <source>Compared as last seen, not up to date: %1</source>
        <translation>Verglichen wie zuletzt gesehen, nicht aktuell: %1</translation>
    </message>
    <message>
        <source>of the connected encoder, not up to date. %1</source>
        <comment>why, when</comment>
        <translation>vom angeschlossenen Geber, nicht aktuell. %1</translation>
    </message>
    <message>
        <source>%1 (not up to date)</source>
        <comment>result</comment>
        <translation>%1 (nicht aktuell)</translation>
    </message>
    <message>
        <source>of a simulated encoder</source>
        <translation>eines simulierten Gebers</translation>
    </message>
    <message>
        <source>Known values are: read, from the encoder; confirmed, by the encoder in a handshake, after which it went into operation with them; by hand, set by somebody, and the encoder was not asked; unknown, nobody knows what the encoder has.</source>
        <translation>Herkunft bekannter Werte: gelesen: vom Geber beim Auslesen gemeldet; quittiert: vom Geber im Handshake quittiert und mit Run übernommen; von Hand: eingetragen, der Geber wurde nicht gefragt; unbekannt: Der Wert im Geber ist nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>codewheel::RequestField</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Sends the request</source>
        <translation>Sendet die Anfrage</translation>
    </message>
    <message>
        <source>The request typed before, or after</source>
        <translation>Die vorige oder nächste eingegebene Anfrage</translation>
    </message>
    <message>
        <source>Lists the commands</source>
        <translation>Zeigt alle Befehle</translation>
    </message>
</context>
<context>
    <name>codewheel::ReviewPage</name>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>&amp;Write all, including what is already there</source>
        <translation>A&amp;lles schreiben, auch schon Vorhandenes</translation>
    </message>
    <message>
        <source>Step by step, b&amp;y hand</source>
        <translation>&amp;Schritt für Schritt, von Hand</translation>
    </message>
    <message>
        <source>&amp;Running by itself</source>
        <translation>Auto&amp;matisch</translation>
    </message>
    <message>
        <source>Old and new values</source>
        <translation>Alte und neue Werte</translation>
    </message>
    <message>
        <source>Words that will be sent</source>
        <translation>Worte, die gesendet werden</translation>
    </message>
    <message>
        <source>Words that will be sent, in this order:</source>
        <translation>Worte, die gesendet werden, in dieser Reihenfolge:</translation>
    </message>
    <message>
        <source>already there, not written</source>
        <translation>vorhanden, nicht geschrieben</translation>
    </message>
    <message>
        <source>read, written if it differs</source>
        <translation>ausgelesen, bei Abweichung geschrieben</translation>
    </message>
    <message>
        <source>written</source>
        <translation>wird geschrieben</translation>
    </message>
    <message>
        <source>The encoder has all of these values already: there is nothing to write. Go back and change a value, or write all.</source>
        <translation>Der Geber hat alle diese Werte schon: Es gibt nichts zu schreiben. Zurückgehen und einen Wert ändern, oder alles schreiben.</translation>
    </message>
    <message>
        <source>The position cannot be set: the mode of the encoder is not known, and in cam mode the same word sets a cam. Say on the page What is known that it is in position mode, or do not set the position.</source>
        <translation>Die Position lässt sich nicht setzen: Die Betriebsart des Gebers ist unbekannt, und im Nockenbetrieb setzt dasselbe Wort einen Nocken. Auf der Seite „Was bekannt ist“ den Positionsbetrieb angeben oder die Position nicht setzen.</translation>
    </message>
    <message>
        <source>Afterwards each written value is read back.</source>
        <translation>Danach wird jeder geschriebene Wert zurückgelesen.</translation>
    </message>
    <message>
        <source>This encoder cannot be read: its confirmation, and operation after run, are the evidence.</source>
        <translation>Dieser Geber lässt sich nicht auslesen: Der Nachweis sind seine Quittung und der Betrieb nach Run.</translation>
    </message>
    <message>
        <source>&amp;Start the handshake</source>
        <translation>Handshake s&amp;tarten</translation>
    </message>
    <message>
        <source>the position is set to it</source>
        <translation>die Position wird darauf gesetzt</translation>
    </message>
    <message>
        <source>The encoder is in cam mode, which refuses parameters. Switch it to position mode first, with the functions of the parameter panel.</source>
        <translation>Der Geber ist im Nockenbetrieb, der Parameter ablehnt. Erst mit den Funktionen im Bereich „Parameter“ in den Positionsbetrieb schalten.</translation>
    </message>
    <message>
        <source>Each step waits until you press Next step.</source>
        <translation>Jeder Schritt wartet auf „Nächster Schritt“.</translation>
    </message>
    <message>
        <source>The steps follow each other as the encoder confirms them.</source>
        <translation>Die Schritte laufen nacheinander ab, sobald der Geber quittiert.</translation>
    </message>
    <message>
        <source>Requests that will be sent, in this order:</source>
        <translation>Anfragen, die gesendet werden, in dieser Reihenfolge:</translation>
    </message>
    <message>
        <source>The encoder gives no valid position now. If that stays so, the values are written, and the position is not set.</source>
        <translation>Der Geber gibt jetzt keine gültige Position aus. Bleibt das so, werden die Werte geschrieben, und die Position wird nicht gesetzt.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>Each write uses up one of the writes of the encoder&apos;s EEPROM.</source>
        <translation>Jedes Schreiben kostet das EEPROM des Gebers einen seiner Schreibvorgänge.</translation>
    </message>
    <message>
        <source>already there, written if used up</source>
        <translation>vorhanden, geschrieben, falls verbraucht</translation>
    </message>
    <message>
        <source>not wanted, goes along</source>
        <translation>nicht gewünscht, geht mit</translation>
    </message>
    <message>
        <source>The encoder had all of these values when it was seen last. Whether it has them now is not known: %1</source>
        <comment>a sentence</comment>
        <translation>Als der Geber zuletzt zu sehen war, hatte er alle diese Werte. Ob er sie jetzt hat, ist nicht bekannt: %1</translation>
    </message>
    <message>
        <source>This encoder cannot be read: its confirmation is the evidence.</source>
        <translation>Dieser Geber lässt sich nicht auslesen: Der Nachweis ist seine Quittung.</translation>
    </message>
    <message>
        <source>It costs no EEPROM write: the encoder keeps no value without supply.</source>
        <translation>Das kostet keinen EEPROM-Schreibvorgang: Der Geber behält ohne Versorgung keinen Wert.</translation>
    </message>
    <message>
        <source>in force already, only stored</source>
        <translation>gilt schon, wird nur gespeichert</translation>
    </message>
    <message>
        <source>Writes everything that is wanted once more.</source>
        <translation>Schreibt alles Gewünschte noch einmal.</translation>
    </message>
</context>
<context>
    <name>codewheel::RingActions</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Connects to the ring; nothing is sent</source>
        <translation>Verbindet mit dem Ring; es wird nichts gesendet</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>Leaves the ring: work goes on offline</source>
        <translation>Trennt die Verbindung zum Ring; offline geht es weiter</translation>
    </message>
    <message>
        <source>&amp;Read in the ring</source>
        <translation>&amp;Ring einlesen</translation>
    </message>
    <message>
        <source>&amp;Confirm diagnostics</source>
        <translation>Diagnose &amp;quittieren</translation>
    </message>
    <message>
        <source>Confirms peripheral faults; one whose cause is still there comes back. Needs Operate.</source>
        <translation>Quittiert Peripheriefehler; einer, dessen Ursache noch da ist, kommt wieder. Nur in Bedienen möglich.</translation>
    </message>
    <message>
        <source>Switch se&amp;gment off or on</source>
        <translation>Se&amp;gment ab- oder zuschalten</translation>
    </message>
    <message>
        <source>Takes the segment of the chosen device, and what is behind it, out of the data cycles, after asking, or puts it back. Needs Operate.</source>
        <translation>Nimmt das Segment des gewählten Geräts mit allem dahinter nach einer Rückfrage aus den Datenzyklen oder schaltet es wieder zu. Nur in Bedienen möglich.</translation>
    </message>
    <message>
        <source>The ring is not connected.</source>
        <translation>Der Ring ist nicht verbunden.</translation>
    </message>
    <message>
        <source>No device with a segment of this ring is chosen.</source>
        <translation>Kein Gerät mit einem Segment dieses Rings ist gewählt.</translation>
    </message>
    <message>
        <source>The master finds the devices of the ring again; data cycles stop meanwhile. Needs Operate.</source>
        <translation>Der Master sucht die Teilnehmer des Rings neu; die Datenzyklen stehen solange still. Nur in Bedienen möglich.</translation>
    </message>
    <message>
        <source>Connec&amp;tion…</source>
        <translation>&amp;Verbindung…</translation>
    </message>
    <message>
        <source>How this ring is reached: training bus, or a gateway; with a test</source>
        <translation>Wie dieser Ring erreicht wird: Übungsbus oder Gateway; mit einem Test</translation>
    </message>
    <message>
        <source>Re&amp;gisters…</source>
        <translation>Re&amp;gister…</translation>
    </message>
    <message>
        <source>The registers of each device, its word in four readings, and the word order</source>
        <translation>Die Register jedes Teilnehmers, sein Wort in vier Lesarten und die Wortreihenfolge</translation>
    </message>
    <message>
        <source>Only a ring behind a gateway has registers.</source>
        <translation>Nur ein Ring hinter einem Gateway hat Register.</translation>
    </message>
    <message>
        <source>&amp;Offer to others…</source>
        <translation>&amp;Anderen anbieten…</translation>
    </message>
    <message>
        <source>&amp;Stop offering</source>
        <translation>Nicht &amp;mehr anbieten</translation>
    </message>
    <message>
        <source>The ring is no longer offered to others: all clients are disconnected</source>
        <translation>Der Ring wird anderen nicht mehr angeboten: Alle Clients werden getrennt</translation>
    </message>
    <message>
        <source>Tr&amp;aining</source>
        <translation>Üb&amp;ung</translation>
    </message>
    <message>
        <source>Any Modbus client can work on this simulated ring; who does is shown there</source>
        <translation>Jeder Modbus-Client kann an diesem simulierten Ring arbeiten; wer es tut, steht dort</translation>
    </message>
    <message>
        <source>Modbus, TCP, RTU, gateway</source>
        <translation>Modbus, TCP, RTU, Gateway, Kopplung</translation>
    </message>
    <message>
        <source>word order, byte order, gateway</source>
        <translation>Wortreihenfolge, Bytereihenfolge, Gateway</translation>
    </message>
    <message>
        <source>Start a&amp;fresh</source>
        <translation>Neu b&amp;eginnen</translation>
    </message>
    <message>
        <source>reset, factory settings, no faults</source>
        <translation>zurücksetzen, Werkseinstellungen, keine Störungen, Reset</translation>
    </message>
</context>
<context>
    <name>codewheel::RingChecks</name>
    <message>
        <source>%1 requests, %2 without an answer</source>
        <translation>%1 Anfragen, %2 ohne Antwort</translation>
    </message>
    <message>
        <source>exception %1: %2 times</source>
        <translation>Exception %1: %2-mal</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>ALARM STOP has stopped the ring. Start it once it may run again.</source>
        <translation>ALARM-STOPP hat den Ring angehalten. Starten, sobald er wieder laufen darf.</translation>
    </message>
    <message>
        <source>The ring was stopped from here. Start it.</source>
        <translation>Der Ring wurde in diesem Programm angehalten. Starten.</translation>
    </message>
    <message>
        <source>The ring does not run, and was not stopped from here. Look at its master, then start it.</source>
        <translation>Der Ring läuft nicht und wurde nicht in diesem Programm angehalten. Nach seinem Master sehen, dann starten.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>a state, a device</comment>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>The ring is being read in. Wait for it.</source>
        <translation>Der Ring wird eingelesen. Abwarten.</translation>
    </message>
    <message>
        <source>Place in the ring</source>
        <translation>Platz im Ring</translation>
    </message>
    <message>
        <source>no such device</source>
        <translation>kein solches Gerät</translation>
    </message>
    <message>
        <source>there</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>Reports of the master</source>
        <translation>Meldungen des Masters</translation>
    </message>
    <message>
        <source>no fault</source>
        <translation>keine Störung</translation>
    </message>
    <message>
        <source>words that do not agree</source>
        <translation>Worte, die nicht übereinstimmen</translation>
    </message>
    <message>
        <source>its registers are read</source>
        <translation>seine Register werden gelesen</translation>
    </message>
    <message>
        <source>the gateway does not say</source>
        <translation>das Gateway sagt es nicht</translation>
    </message>
    <message>
        <source>the gateway does not say: no status register is set</source>
        <translation>das Gateway sagt es nicht: kein Statusregister eingestellt</translation>
    </message>
    <message>
        <source>not known: what the bits of its status register mean is not set</source>
        <translation>nicht bekannt: Was die Bits seines Statusregisters bedeuten, ist nicht eingestellt</translation>
    </message>
    <message>
        <source>The reads of %1 do not agree, so its word is not believed. Check the word order, and where its registers begin. If they are right, stop the shaft or make the poll interval shorter: a position that moves is believed where reads follow each other closely.</source>
        <translation>Die Lesungen von %1 stimmen nicht überein, daher gilt sein Wort nicht. Die Wortreihenfolge prüfen, und wo seine Register beginnen. Stimmen sie, die Welle anhalten oder das Abfrageintervall verkürzen: Eine Position, die sich bewegt, gilt, wo die Lesungen dicht aufeinander folgen.</translation>
    </message>
    <message>
        <source>A fault has stopped the ring. It is not told any more: start the ring again.</source>
        <translation>Eine Störung hat den Ring angehalten. Sie wird nicht mehr gemeldet: den Ring neu starten.</translation>
    </message>
    <message>
        <source>%1, or no supply</source>
        <comment>a position</comment>
        <translation>%1, oder keine Versorgung</translation>
    </message>
</context>
<context>
    <name>codewheel::RingComparison</name>
    <message>
        <source>a configuration without a name</source>
        <translation>eine Konfiguration ohne Namen</translation>
    </message>
    <message>
        <source>&amp;Read in the ring</source>
        <translation>&amp;Ring einlesen</translation>
    </message>
    <message>
        <source>Chosen lines into the &amp;master</source>
        <translation>Gewählte Zeilen in den &amp;Master</translation>
    </message>
    <message>
        <source>Downloads the connected ring with the chosen lines as they are planned; the master keeps it</source>
        <translation>Lädt den angeschlossenen Ring mit den gewählten Zeilen wie geplant in den Master, der ihn speichert</translation>
    </message>
    <message>
        <source>Project into the mas&amp;ter</source>
        <translation>Projekt in den Mas&amp;ter</translation>
    </message>
    <message>
        <source>Downloads the planned ring, which the master keeps, and loads it back</source>
        <translation>Lädt den geplanten Ring in den Master, der ihn speichert, und liest ihn zurück</translation>
    </message>
    <message>
        <source>What the master &amp;keeps into the project</source>
        <translation>&amp;Konfiguration des Masters ins Projekt</translation>
    </message>
    <message>
        <source>Loads the configuration that the master keeps, and plans the ring as it says; can be undone</source>
        <translation>Lädt die im Master gespeicherte Konfiguration und plant den Ring danach; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Load the configuration of the master</source>
        <translation>Konfiguration des Masters laden</translation>
    </message>
    <message numerus="yes">
        <source>The ring is planned as the master keeps it: %1, %n devices.</source>
        <translation>
            <numerusform>Der Ring ist geplant, wie im Master gespeichert: %1, %n Teilnehmer.</numerusform>
            <numerusform>Der Ring ist geplant, wie im Master gespeichert: %1, %n Teilnehmer.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Rückgängig</translation>
    </message>
    <message numerus="yes">
        <source>The master keeps %1 with %n devices.</source>
        <translation>
            <numerusform>Im Master ist %1 mit %n Teilnehmer gespeichert.</numerusform>
            <numerusform>Im Master ist %1 mit %n Teilnehmern gespeichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Loaded back, it is the project&apos;s.</source>
        <translation>Zurückgelesen stimmt sie mit dem Projekt überein.</translation>
    </message>
    <message numerus="yes">
        <source>Loaded back, %n lines differ from the project.</source>
        <translation>
            <numerusform>Beim Zurücklesen weicht %n Zeile vom Projekt ab.</numerusform>
            <numerusform>Beim Zurücklesen weichen %n Zeilen vom Projekt ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>The master finds the devices of the ring again; data cycles stop meanwhile</source>
        <translation>Der Master sucht die Teilnehmer des Rings neu; die Datenzyklen stehen solange still</translation>
    </message>
    <message>
        <source>Changes the project, or the master, as you choose; the master only in Operate.</source>
        <translation>Ändert je nach Wahl das Projekt oder den Master; den Master nur in Bedienen.</translation>
    </message>
</context>
<context>
    <name>codewheel::RingConnection</name>
    <message numerus="yes">
        <source>Reading in the ring: %n devices found.</source>
        <translation>
            <numerusform>Ring wird eingelesen: %n Teilnehmer gefunden.</numerusform>
            <numerusform>Ring wird eingelesen: %n Teilnehmer gefunden.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::RingFaults</name>
    <message>
        <source>The cable before the device: the bus fails, and the master finds the place</source>
        <translation>Das Kabel vor dem Teilnehmer: Der Bus fällt aus, und der Master findet den Ort</translation>
    </message>
    <message>
        <source>The whole device: the ring is interrupted at it</source>
        <translation>Der ganze Teilnehmer: Der Ring ist dort unterbrochen</translation>
    </message>
    <message>
        <source>The device reports it. The bus goes on; the fault stays until it is confirmed.</source>
        <translation>Der Teilnehmer meldet ihn. Der Bus läuft weiter; der Fehler bleibt, bis er quittiert wird.</translation>
    </message>
    <message>
        <source>IN 98000004, by itself</source>
        <translation>IN 98000004, von selbst</translation>
    </message>
    <message>
        <source>CRC errors per 1000</source>
        <translation>CRC-Fehler je 1000</translation>
    </message>
    <message>
        <source>CRC errors of 1000 data cycles</source>
        <translation>CRC-Fehler von 1000 Datenzyklen</translation>
    </message>
    <message>
        <source>Faulty data cycles of 1000 in the segment of the device</source>
        <translation>Fehlerhafte Datenzyklen von 1000 im Segment des Teilnehmers</translation>
    </message>
    <message>
        <source>The cable behind %1 is interrupted. Check plug and shield.</source>
        <translation>Das Kabel hinter %1 ist unterbrochen. Stecker und Schirm prüfen.</translation>
    </message>
    <message>
        <source>The cable between %1 and %2 is interrupted, or %2 has no supply. Check plug, shield and 24 V.</source>
        <translation>Das Kabel zwischen %1 und %2 ist unterbrochen, oder %2 hat keine Versorgung. Stecker, Schirm und 24&#xa0;V prüfen.</translation>
    </message>
    <message>
        <source>the master</source>
        <translation>dem Master</translation>
    </message>
    <message>
        <source>The ring has failed. The master is looking for the place: wait for it.</source>
        <translation>Der Ring ist ausgefallen. Der Master sucht die Stelle: abwarten.</translation>
    </message>
    <message>
        <source>The ring has failed, but the master finds nothing any more. Check shields, plugs and 24 V, then start again.</source>
        <translation>Der Ring ist ausgefallen, aber der Master findet nichts mehr. Schirme, Stecker und 24&#xa0;V prüfen, dann neu starten.</translation>
    </message>
    <message>
        <source>The ring has failed, and the master does not tell where. Check plugs, shields and 24 V, and look up its code.</source>
        <translation>Der Ring ist ausgefallen, und der Master nennt keine Stelle. Stecker, Schirme und 24&#xa0;V prüfen und den Code nachschlagen.</translation>
    </message>
    <message>
        <source>The ring has failed. Look at the display of its master.</source>
        <translation>Der Ring ist ausgefallen. Die Anzeige am Master ansehen.</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>The program looks for the ring each second. Check the cable to the master, and whether it is switched on.</source>
        <translation>Das Programm sucht den Ring jede Sekunde. Das Kabel zum Master prüfen, und ob er eingeschaltet ist.</translation>
    </message>
    <message>
        <source>periphery</source>
        <comment>fault of it, one word</comment>
        <translation>Peripherie</translation>
    </message>
    <message>
        <source>%1 reports a fault of its periphery, and the ring runs on. Check what is connected to it, and its supply; then confirm.</source>
        <translation>%1 meldet eine Peripheriestörung, der Ring läuft weiter. Prüfen, was angeschlossen ist und wie es versorgt wird, dann quittieren.</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>CRC-Fehler</translation>
    </message>
    <message>
        <source>Many data cycles are faulty: %1 in segment %2. Check plugs and shield of the cable between %3 and %4, and what disturbs it.</source>
        <translation>Viele Datenzyklen sind fehlerhaft: %1 in Segment %2. Stecker und Schirm des Kabels zwischen %3 und %4 prüfen, und was es stört.</translation>
    </message>
    <message>
        <source>A K2 is there instead of what is configured: the bus fails</source>
        <translation>Dort steht ein K2 statt des projektierten Geräts: Der Bus fällt aus</translation>
    </message>
    <message>
        <source>%1 is not found as configured: it has no supply, the cable between %2 and %1 is interrupted, or another device is there. Check 24 V, plug, and which device it is.</source>
        <translation>%1 wird nicht wie projektiert gefunden: Die Versorgung fehlt, das Kabel zwischen %2 und %1 ist unterbrochen, oder dort ist ein anderes Gerät. 24&#xa0;V, Stecker und Gerät prüfen.</translation>
    </message>
    <message>
        <source>The gateway is tried again each second.</source>
        <translation>Das Gateway wird jede Sekunde neu versucht.</translation>
    </message>
    <message>
        <source>zeros missing</source>
        <comment>of ALARM STOP</comment>
        <translation>Nullen fehlen</translation>
    </message>
    <message>
        <source>outputs blocked</source>
        <comment>of a gateway</comment>
        <translation>Ausgänge gesperrt</translation>
    </message>
    <message>
        <source>The gateway did not carry out the last write (exception 4). The watchdog of its outputs may have tripped: acknowledge it, then go to Operate again.</source>
        <translation>Das Gateway hat das letzte Schreiben nicht ausgeführt (Exception 4). Der Watchdog seiner Ausgänge hat vielleicht angesprochen: Quittieren Sie ihn und schalten Sie dann wieder auf Bedienen.</translation>
    </message>
    <message>
        <source>%1 was left in OUT of %2. The encoder may show no position, and the controller gets none.</source>
        <translation>%1 ist in OUT von %2 stehen geblieben. Der Geber zeigt vielleicht keine Position, und die Steuerung bekommt keine.</translation>
    </message>
    <message>
        <source>%1 may have been left in OUT of %2, which cannot be read back. The encoder may show no position then.</source>
        <translation>%1 steht vielleicht noch in OUT von %2, das sich nicht zurücklesen lässt. Dann zeigt der Geber vielleicht keine Position.</translation>
    </message>
    <message>
        <source>In OUT when it was last seen: %1.</source>
        <translation>In OUT, als es zuletzt gesehen wurde: %1.</translation>
    </message>
    <message>
        <source>The ring could not be started.</source>
        <translation>Der Ring ließ sich nicht starten.</translation>
    </message>
</context>
<context>
    <name>codewheel::RingKind</name>
    <message>
        <source>INTERBUS ring</source>
        <translation>INTERBUS-Ring</translation>
    </message>
    <message>
        <source>training bus (simulated)</source>
        <translation>Übungsbus (simuliert)</translation>
    </message>
</context>
<context>
    <name>codewheel::RingLinks</name>
    <message>
        <source>Training bus</source>
        <translation>Übungsbus</translation>
    </message>
    <message>
        <source>A simulated ring in this program. Nothing leaves this computer.</source>
        <translation>Ein simulierter Ring in diesem Programm. Nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>The fields are filled in.</source>
        <translation>Die Felder sind ausgefüllt.</translation>
    </message>
</context>
<context>
    <name>codewheel::RingOffer</name>
    <message>
        <source>%1, seat %2</source>
        <comment>the ring of a seat</comment>
        <translation>%1, Sitzplatz %2</translation>
    </message>
    <message>
        <source>Connected clients: %1.</source>
        <translation>Verbundene Clients: %1.</translation>
    </message>
    <message>
        <source>The rings of all seats end, with all that was written to them.</source>
        <translation>Die Ringe aller Plätze enden, mit allem, was in sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>What was written to this seat is lost. Whoever is connected sees its ring stand for 2 s.</source>
        <translation>Was an diesem Sitzplatz geschrieben wurde, geht verloren. Wer verbunden ist, sieht den Ring 2 s lang stehen.</translation>
    </message>
</context>
<context>
    <name>codewheel::RingOutline</name>
    <message>
        <source>%1  %2
ID code %3, device code %4
Words: IN %5, OUT %6
State: %7</source>
        <translation>%1  %2
ID-Code %3, Gerätecode %4
Worte: IN %5, OUT %6
Zustand: %7</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Master</translation>
    </message>
    <message>
        <source>The master of the ring is in the state %1.</source>
        <translation>Der Master des Rings ist im Zustand %1.</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>read-out</source>
        <translation>Auslesen</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>Position: Gray code</source>
        <translation>Position: Gray-Code</translation>
    </message>
    <message>
        <source>Position: signed</source>
        <translation>Position: mit Vorzeichen</translation>
    </message>
    <message>
        <source>LEDs: %1</source>
        <translation>LEDs: %1</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>all OUT words become 0, and jobs end</source>
        <translation>alle OUT-Worte werden 0, und Aufträge enden</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>off</source>
        <comment>switched off</comment>
        <translation>aus</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgetrennt</translation>
    </message>
    <message>
        <source>job</source>
        <comment>it is running</comment>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>unsent</source>
        <comment>a staged word</comment>
        <translation>ungesendet</translation>
    </message>
    <message>
        <source>parameters</source>
        <comment>parameterization</comment>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>service</source>
        <comment>service mode</comment>
        <translation>Dienst</translation>
    </message>
    <message>
        <source>unknown</source>
        <comment>state</comment>
        <translation>unklar</translation>
    </message>
    <message>
        <source>periphery</source>
        <comment>fault of it</comment>
        <translation>Peripherie</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Gateway</source>
        <translation>Gateway</translation>
    </message>
    <message>
        <source>The gateway to the ring: %1. It does not tell the state of the master.</source>
        <translation>Das Gateway zum Ring: %1. Den Zustand des Masters meldet es nicht.</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>no position</source>
        <translation>ohne Position</translation>
    </message>
    <message>
        <source>The gateway to the ring: %1.</source>
        <translation>Das Gateway zum Ring: %1.</translation>
    </message>
    <message>
        <source>ring failed</source>
        <translation>Ring ausgefallen</translation>
    </message>
    <message>
        <source>ring stands still</source>
        <translation>Ring steht</translation>
    </message>
    <message>
        <source>OUT left</source>
        <comment>a word that a job has left in OUT</comment>
        <translation>OUT steht noch</translation>
    </message>
    <message>
        <source>unsettled</source>
        <comment>no two reads of its word agree</comment>
        <translation>unstimmig</translation>
    </message>
    <message>
        <source>outputs blocked</source>
        <comment>of a gateway</comment>
        <translation>Ausgänge gesperrt</translation>
    </message>
    <message>
        <source>gateway</source>
        <comment>behind the name of a ring</comment>
        <translation>Gateway</translation>
    </message>
</context>
<context>
    <name>codewheel::RingPlanFields</name>
    <message>
        <source>Addresses in</source>
        <translation>Adressen in</translation>
    </message>
    <message>
        <source>How addresses in the process image are shown and typed</source>
        <translation>Wie Adressen im Prozessabbild angezeigt und eingegeben werden</translation>
    </message>
    <message>
        <source>First address</source>
        <translation>Erste Adresse</translation>
    </message>
    <message>
        <source>Where the automatic addresses begin, in bytes</source>
        <translation>Wo die automatischen Adressen beginnen, in Bytes</translation>
    </message>
    <message>
        <source>Step &amp;5</source>
        <translation>Step &amp;5</translation>
    </message>
    <message>
        <source>About how long one bus cycle takes on the wire, by the formulas of G3 and of G4 masters</source>
        <translation>Wie lange ein Buszyklus auf der Leitung etwa dauert, nach den Formeln der G3- und der G4-Master</translation>
    </message>
    <message>
        <source>Length of cable in km</source>
        <translation>Kabellänge in km</translation>
    </message>
    <message>
        <source>Length of all remote bus cables: each km takes 0.016 ms</source>
        <translation>Länge aller Fernbuskabel: Jeder km kostet 0,016 ms</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>words</source>
        <translation>Worten</translation>
    </message>
    <message>
        <source>Addresses i&amp;n</source>
        <translation>Adressen i&amp;n</translation>
    </message>
    <message>
        <source>fr&amp;om byte</source>
        <translation>ab B&amp;yte</translation>
    </message>
    <message>
        <source>Length of cable</source>
        <translation>Kabellänge</translation>
    </message>
    <message>
        <source>Cable in k&amp;m</source>
        <translation>Kabel in k&amp;m</translation>
    </message>
    <message>
        <source>Addresses</source>
        <translation>Adressen</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Teilnehmer</translation>
    </message>
    <message>
        <source>remote bus</source>
        <translation>Fernbus</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>longest local bus</source>
        <translation>längster Lokalbus</translation>
    </message>
    <message>
        <source>PCP</source>
        <translation>PCP</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>Ausgänge</translation>
    </message>
    <message>
        <source>Cycle about %1 ms at 500 kBd, %2 ms at 2 MBd (G3 / G4)</source>
        <translation>Zyklus etwa %1 ms bei 500 kBd, %2 ms bei 2 MBd (G3 / G4)</translation>
    </message>
    <message>
        <source>With a Step 5 PLC, encoders must be above P127: this is checked</source>
        <translation>Bei einer Step-5-Steuerung müssen Geber über P127 liegen: Das wird geprüft</translation>
    </message>
</context>
<context>
    <name>codewheel::RingPlanRules</name>
    <message>
        <source>It has no such words.</source>
        <translation>Worte dieser Art hat das Gerät nicht.</translation>
    </message>
    <message>
        <source>Bytes %1 to %2</source>
        <translation>Bytes %1 bis %2</translation>
    </message>
    <message>
        <source>Given by hand. Delete the number to have it counted again.</source>
        <translation>Von Hand vergeben. Die Zahl löschen, damit wieder gezählt wird.</translation>
    </message>
    <message>
        <source>Counted in ring order. Type a number to give it by hand.</source>
        <translation>In Ringreihenfolge gezählt. Eine Zahl eintippen, um sie von Hand zu vergeben.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>%1: %2, words: IN %3, OUT %4</source>
        <translation>%1: %2, Worte: IN %3, OUT %4</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>ID code</source>
        <translation>ID-Code</translation>
    </message>
    <message>
        <source>Words IN / OUT</source>
        <translation>Worte IN / OUT</translation>
    </message>
    <message>
        <source>IN byte</source>
        <translation>IN-Byte</translation>
    </message>
    <message>
        <source>IN word</source>
        <translation>IN-Wort</translation>
    </message>
    <message>
        <source>OUT byte</source>
        <translation>OUT-Byte</translation>
    </message>
    <message>
        <source>OUT word</source>
        <translation>OUT-Wort</translation>
    </message>
    <message>
        <source>ID code %1, device code %2
Words: IN %3, OUT %4</source>
        <translation>ID-Code %1, Gerätecode %2
Worte: IN %3, OUT %4</translation>
    </message>
    <message>
        <source>%1 is not an address. Give a number from 0 to %2, or nothing to have it counted.</source>
        <translation>%1 ist keine Adresse. Eine Zahl von 0 bis %2 eingeben oder nichts, damit gezählt wird.</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Behind %1</source>
        <translation>Hinter %1</translation>
    </message>
    <message>
        <source>Before %1</source>
        <translation>Vor %1</translation>
    </message>
    <message>
        <source>On the local bus of %1</source>
        <translation>Am Lokalbus von %1</translation>
    </message>
    <message>
        <source>In the branch of %1</source>
        <translation>Im Abzweig von %1</translation>
    </message>
</context>
<context>
    <name>codewheel::RingStatus</name>
    <message>
        <source>Cycle time</source>
        <translation>Zykluszeit</translation>
    </message>
    <message>
        <source>The time from one exchange of all words to the next</source>
        <translation>Die Zeit von einem Austausch aller Worte bis zum nächsten</translation>
    </message>
    <message>
        <source>Late cycles</source>
        <translation>Verspätete Zyklen</translation>
    </message>
    <message>
        <source>Cycles that began too late; they are counted, not caught up</source>
        <translation>Zyklen, die zu spät begannen; sie werden gezählt, nicht nachgeholt</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>CRC-Fehler</translation>
    </message>
    <message>
        <source>Faulty data cycles since the ring was started</source>
        <translation>Fehlerhafte Datenzyklen, seit der Ring gestartet wurde</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>How the program is connected to the ring</source>
        <translation>Wie das Programm mit dem Ring verbunden ist</translation>
    </message>
    <message>
        <source>cycle %1 ms</source>
        <translation>Zyklus %1 ms</translation>
    </message>
    <message>
        <source>virtual time</source>
        <translation>virtuelle Zeit</translation>
    </message>
    <message numerus="yes">
        <source>%n late cycles</source>
        <translation>
            <numerusform>%n verspäteter Zyklus</numerusform>
            <numerusform>%n verspätete Zyklen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n CRC errors</source>
        <translation>
            <numerusform>%n CRC-Fehler</numerusform>
            <numerusform>%n CRC-Fehler</numerusform>
        </translation>
    </message>
    <message>
        <source>link: %1</source>
        <translation>Verbindung: %1</translation>
    </message>
    <message>
        <source>training bus</source>
        <translation>Übungsbus</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>%1 exchanges/s</source>
        <translation>%1 Austausche/s</translation>
    </message>
</context>
<context>
    <name>codewheel::RingStrangers</name>
    <message>
        <source>%1 (missing now)</source>
        <translation>%1 (fehlt jetzt)</translation>
    </message>
    <message>
        <source>%1 (moved to %2)</source>
        <translation>%1 (versetzt nach %2)</translation>
    </message>
    <message>
        <source>%1 (its number is %2 now)</source>
        <translation>%1 (hat jetzt die Nummer %2)</translation>
    </message>
    <message>
        <source>perhaps another one: beside it, one of the same kind is missing or additional</source>
        <translation>vielleicht ein anderer: Daneben fehlt einer derselben Art oder ist zusätzlich da</translation>
    </message>
</context>
<context>
    <name>codewheel::RingTraining</name>
    <message>
        <source>Shaft turned to raw position %1.</source>
        <translation>Welle auf Rohposition %1 gedreht.</translation>
    </message>
    <message>
        <source>Shaft turned by hand to raw position %1.</source>
        <translation>Welle von Hand auf Rohposition %1 gedreht.</translation>
    </message>
    <message>
        <source>Shaft stopped.</source>
        <translation>Welle angehalten.</translation>
    </message>
    <message>
        <source>Shaft turns at %1 rpm.</source>
        <translation>Welle dreht mit %1 U/min.</translation>
    </message>
    <message>
        <source>Magnet moved to %1 mm.</source>
        <translation>Magnet auf %1 mm geschoben.</translation>
    </message>
    <message>
        <source>Magnet moved by hand to %1 mm.</source>
        <translation>Magnet von Hand auf %1 mm geschoben.</translation>
    </message>
    <message>
        <source>Magnet stopped.</source>
        <translation>Magnet angehalten.</translation>
    </message>
    <message>
        <source>Magnet moves at %1 mm/s.</source>
        <translation>Magnet bewegt sich mit %1 mm/s.</translation>
    </message>
    <message>
        <source>Magnet back in the measuring range.</source>
        <translation>Magnet wieder im Messbereich.</translation>
    </message>
    <message>
        <source>Magnet outside the measuring range.</source>
        <translation>Magnet außerhalb des Messbereichs.</translation>
    </message>
    <message>
        <source>Power on.</source>
        <translation>Eingeschaltet.</translation>
    </message>
    <message>
        <source>Power off.</source>
        <translation>Ausgeschaltet.</translation>
    </message>
    <message>
        <source>Power off and on.</source>
        <translation>Aus- und eingeschaltet.</translation>
    </message>
    <message>
        <source>Slow confirmation on.</source>
        <translation>Langsame Quittung ein.</translation>
    </message>
    <message>
        <source>Slow confirmation off.</source>
        <translation>Langsame Quittung aus.</translation>
    </message>
    <message>
        <source>Battery low; the encoder finds it when it is switched on.</source>
        <translation>Batterie schwach; der Geber merkt es beim Einschalten.</translation>
    </message>
    <message>
        <source>Battery full; the encoder finds it when it is switched on.</source>
        <translation>Batterie voll; der Geber merkt es beim Einschalten.</translation>
    </message>
    <message>
        <source>EEPROM worn out.</source>
        <translation>EEPROM verschlissen.</translation>
    </message>
    <message>
        <source>EEPROM in order.</source>
        <translation>EEPROM in Ordnung.</translation>
    </message>
    <message>
        <source>Code disc faulty.</source>
        <translation>Codescheibe defekt.</translation>
    </message>
    <message>
        <source>Code disc in order; run ends the error.</source>
        <translation>Codescheibe in Ordnung; Run beendet den Fehler.</translation>
    </message>
    <message>
        <source>Parameters lost.</source>
        <translation>Parameter verloren.</translation>
    </message>
    <message>
        <source>Seat %1: %2</source>
        <translation>Sitzplatz %1: %2</translation>
    </message>
    <message>
        <source>Seat %1, %2: %3</source>
        <translation>Sitzplatz %1, %2: %3</translation>
    </message>
</context>
<context>
    <name>codewheel::RingViews</name>
    <message>
        <source>Start again</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Activates the configuration, and starts data transfer</source>
        <translation>Aktiviert die Konfiguration und startet die Datenübertragung</translation>
    </message>
    <message>
        <source>The ring is being read in.</source>
        <translation>Der Ring wird gerade eingelesen.</translation>
    </message>
    <message>
        <source>The program only watches. Switch to Operate first.</source>
        <translation>Das Programm beobachtet nur. Zuerst auf Bedienen umschalten.</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Confirms the diagnostics; a fault whose cause is still there comes back</source>
        <translation>Quittiert die Diagnose; eine Störung, deren Ursache noch besteht, kommt wieder</translation>
    </message>
    <message>
        <source>Switch segment off</source>
        <translation>Segment abschalten</translation>
    </message>
    <message>
        <source>Takes segment %1, and what is behind it, out of the data cycles, after asking. The rest can be started then.</source>
        <translation>Nimmt Segment %1 und was dahinter liegt nach einer Rückfrage aus den Datenzyklen. Der Rest lässt sich dann starten.</translation>
    </message>
    <message>
        <source>Shafts can be turned and faults caused on a training bus only.</source>
        <translation>Nur an einem Übungsbus lassen sich Wellen drehen und Fehler auslösen.</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Goes to Operate, sets OUT of %1 to 00000000, and reads what is not known since</source>
        <translation>Wechselt zu Bedienen, setzt OUT von %1 auf 00000000 und liest, was seitdem nicht bekannt ist</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Writes the register that acknowledges the watchdog of the gateway, as the connection says</source>
        <translation>Schreibt das Register, das den Watchdog des Gateways quittiert, wie in der Verbindung eingetragen</translation>
    </message>
    <message>
        <source>The bus does not run. Start it first.</source>
        <translation>Der Bus läuft nicht. Starten Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>Send run</source>
        <translation>Run senden</translation>
    </message>
    <message>
        <source>Sends 80000000 to %1, then 00000000: what it has taken becomes valid, and it shows its position again</source>
        <translation>Sendet 80000000 an %1, dann 00000000: Was er übernommen hat, wird gültig, und er zeigt seine Position wieder</translation>
    </message>
    <message>
        <source>Operate, and bring back</source>
        <translation>Bedienen und zurückholen</translation>
    </message>
    <message>
        <source>Not a training bus</source>
        <translation>Kein Übungsbus</translation>
    </message>
    <message>
        <source>Position mode</source>
        <translation>Positionsbetrieb</translation>
    </message>
    <message>
        <source>Operate, and position mode</source>
        <translation>Bedienen und Positionsbetrieb</translation>
    </message>
    <message>
        <source>Switches %1 back to position mode, after asking</source>
        <translation>Schaltet %1 nach einer Rückfrage zurück in den Positionsbetrieb</translation>
    </message>
    <message>
        <source>The ring is not connected.</source>
        <translation>Der Ring ist nicht verbunden.</translation>
    </message>
</context>
<context>
    <name>codewheel::RodConsequences</name>
    <message>
        <source>The resolution is shown once the measuring length is known or wanted.</source>
        <translation>Die Auflösung lässt sich bestimmen, sobald die Messlänge bekannt oder gewünscht ist.</translation>
    </message>
    <message>
        <source>Positions from 0 to %1. For mm, calculate the measuring length from the length of the rod, or set that length under What is known.</source>
        <translation>Positionen von 0 bis %1. Für mm die Messlänge aus der Stablänge berechnen oder die Stablänge unter „Was bekannt ist“ eintragen.</translation>
    </message>
    <message>
        <source>Positions from 0 to %1 over %2 mm: %3.</source>
        <translation>Positionen von 0 bis %1 über %2 mm: %3.</translation>
    </message>
    <message>
        <source>The external preset %1 lies beyond the measuring length of %2 steps.</source>
        <translation>Der externe Preset %1 liegt jenseits der Messlänge von %2 Schritten.</translation>
    </message>
    <message>
        <source>The position to be set, %1, lies beyond the measuring length of %2 steps.</source>
        <translation>Die zu setzende Position %1 liegt jenseits der Messlänge von %2 Schritten.</translation>
    </message>
</context>
<context>
    <name>codewheel::RodControls</name>
    <message>
        <source>Place of the magnet in mm</source>
        <translation>Ort des Magneten in mm</translation>
    </message>
    <message>
        <source>Magnet on the rod</source>
        <translation>Magnet auf dem Stab</translation>
    </message>
    <message>
        <source>Move the magnet by hand: drag, or use the arrow keys and Page Up, Page Down. The head is at the left.</source>
        <translation>Den Magneten von Hand bewegen: ziehen, oder mit Pfeiltasten und Bild auf, Bild ab. Der Kopf ist links.</translation>
    </message>
    <message>
        <source>Place, mm</source>
        <translation>Ort, mm</translation>
    </message>
    <message>
        <source>Magnet in range</source>
        <translation>Magnet im Bereich</translation>
    </message>
    <message>
        <source>Outside the measuring range the encoder keeps its last position and sets the error bit</source>
        <translation>Außerhalb des Messbereichs behält der Geber seine letzte Position und setzt das Fehlerbit</translation>
    </message>
    <message>
        <source>Place to move the magnet to, in mm</source>
        <translation>Ort, an den der Magnet geschoben wird, in mm</translation>
    </message>
    <message>
        <source>mm from the head; Enter moves the magnet there</source>
        <translation>mm vom Kopf aus; Eingabe schiebt den Magneten dorthin</translation>
    </message>
    <message>
        <source>Move the magnet to the place</source>
        <translation>Den Magneten an den Ort schieben</translation>
    </message>
    <message>
        <source>Move to</source>
        <translation>Schieben auf</translation>
    </message>
    <message>
        <source>Speed in mm per second</source>
        <translation>Geschwindigkeit in mm pro Sekunde</translation>
    </message>
    <message>
        <source>mm per second; positive is away from the head. The magnet turns round at the ends.</source>
        <translation>mm pro Sekunde; positiv ist vom Kopf weg. An den Enden kehrt der Magnet um.</translation>
    </message>
    <message>
        <source>Stop the magnet</source>
        <translation>Den Magneten anhalten</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Geschw., mm/s</translation>
    </message>
</context>
<context>
    <name>codewheel::RodDial</name>
    <message>
        <source>Read error &amp;status</source>
        <translation>Fehler&amp;status lesen</translation>
    </message>
    <message>
        <source>&amp;Set manually</source>
        <translation>&amp;Eintragen</translation>
    </message>
    <message>
        <source>Reads why the error bit is set. That clears it, once the magnet is back.</source>
        <translation>Liest, warum das Fehlerbit gesetzt ist. Das löscht es, sobald der Magnet zurück ist.</translation>
    </message>
    <message>
        <source>Rod &amp;length, from its label:</source>
        <translation>Stab&amp;länge, vom Typenschild:</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Not known: %1.</source>
        <translation>Unbekannt: %1.</translation>
    </message>
    <message>
        <source>mm unknown: set the rod length from its label.</source>
        <translation>mm unbekannt: Die Stablänge vom Typenschild eintragen.</translation>
    </message>
    <message>
        <source>Sets the length manually. Nothing is sent.</source>
        <translation>Trägt die Länge von Hand ein. Gesendet wird nichts.</translation>
    </message>
    <message>
        <source>The position was set by a preset: where the magnet is on the rod is not known.</source>
        <translation>Die Position wurde durch einen Preset gesetzt: Wo der Magnet auf dem Stab steht, ist unbekannt.</translation>
    </message>
</context>
<context>
    <name>codewheel::RodPanel</name>
    <message>
        <source>From rod length and resolution</source>
        <translation>Aus Stablänge und Auflösung</translation>
    </message>
    <message>
        <source>&amp;Use this</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Rod &amp;length, mm</source>
        <translation>Stab&amp;länge, mm</translation>
    </message>
    <message>
        <source>Length of the rod</source>
        <translation>Länge des Stabs</translation>
    </message>
    <message>
        <source>The measuring length in mm, on the label of the rod.</source>
        <translation>Die Messlänge in mm, auf dem Typenschild des Stabs.</translation>
    </message>
    <message>
        <source>mm per s&amp;tep</source>
        <translation>mm je Schr&amp;itt</translation>
    </message>
    <message>
        <source>Wanted resolution</source>
        <translation>Gewünschte Auflösung</translation>
    </message>
    <message>
        <source>mm for one step of the position.</source>
        <translation>mm für einen Schritt der Position.</translation>
    </message>
    <message>
        <source>%1 steps (%2): %3, %4 mm off over %5 mm.</source>
        <translation>%1 Schritte (%2): %3, Abweichung %4 mm auf %5 mm.</translation>
    </message>
    <message>
        <source>The encoder cannot resolve this. Choose more mm per step.</source>
        <translation>So fein löst der Geber nicht auf. Mehr mm je Schritt wählen.</translation>
    </message>
    <message>
        <source>Adds this measuring length to the wanted values, and sets the length of the rod manually.</source>
        <translation>Übernimmt diese Messlänge in die gewünschten Werte und trägt die Stablänge von Hand ein.</translation>
    </message>
</context>
<context>
    <name>codewheel::RodView</name>
    <message>
        <source>Rod</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>Rod of %1</source>
        <comment>device number</comment>
        <translation>Stab von %1</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>mm not known</source>
        <translation>mm unbekannt</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 Schritte/s</translation>
    </message>
    <message>
        <source>%1 to the end</source>
        <comment>of the rod</comment>
        <translation>%1 zum Ende</translation>
    </message>
    <message>
        <source>%1 to the head</source>
        <comment>of the rod</comment>
        <translation>%1 zum Kopf</translation>
    </message>
    <message>
        <source>No position yet. Start the bus and choose an encoder in the bus structure.</source>
        <translation>Noch keine Position. Den Bus starten und im Busaufbau einen Geber wählen.</translation>
    </message>
    <message>
        <source>Last position %1</source>
        <translation>Letzte Position %1</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>measuring length %1 steps</source>
        <translation>Messlänge %1 Schritte</translation>
    </message>
    <message>
        <source>Last position</source>
        <translation>Letzte Position</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>From the head</source>
        <translation>Vom Kopf aus</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>codewheel::SavedReport</name>
    <message>
        <source>no font is installed</source>
        <translation>es ist keine Schriftart installiert</translation>
    </message>
    <message>
        <source>the pages could not be painted</source>
        <translation>die Blätter konnten nicht gezeichnet werden</translation>
    </message>
</context>
<context>
    <name>codewheel::ScalePreview</name>
    <message>
        <source>Will read, &amp;after turns from here:</source>
        <translation>Zeigt nach &amp;Umdrehungen ab hier:</translation>
    </message>
    <message>
        <source>Dial with the wanted values</source>
        <translation>Scheibe mit den gewünschten Werten</translation>
    </message>
    <message>
        <source>Turns from here</source>
        <translation>Umdrehungen ab hier</translation>
    </message>
    <message>
        <source>Imagine the shaft turned clockwise by so much; negative: counter-clockwise.</source>
        <translation>Gedachte Drehung der Welle im Uhrzeigersinn; negativ: gegen den Uhrzeigersinn.</translation>
    </message>
</context>
<context>
    <name>codewheel::SeatPanel</name>
    <message>
        <source>Seat %1</source>
        <translation>Sitzplatz %1</translation>
    </message>
</context>
<context>
    <name>codewheel::SeatsModel</name>
    <message>
        <source>Seat</source>
        <translation>Sitzplatz</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clients</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Written last</source>
        <translation>Zuletzt geschrieben</translation>
    </message>
    <message>
        <source>Its number is the Modbus unit</source>
        <translation>Seine Nummer ist die Modbus-Unit</translation>
    </message>
    <message>
        <source>How many clients asked this unit last</source>
        <translation>Wie viele Clients zuletzt diese Unit gefragt haben</translation>
    </message>
    <message>
        <source>State of its ring</source>
        <translation>Zustand seines Rings</translation>
    </message>
    <message>
        <source>IN</source>
        <translation>IN</translation>
    </message>
    <message>
        <source>OUT</source>
        <translation>OUT</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Störungen</translation>
    </message>
    <message>
        <source>IN word of the device that is chosen above</source>
        <translation>IN-Wort des Geräts, das oben gewählt ist</translation>
    </message>
    <message>
        <source>OUT word of the device that is chosen above</source>
        <translation>OUT-Wort des Geräts, das oben gewählt ist</translation>
    </message>
    <message>
        <source>What the trainer or a fault plan has caused in its ring, and is not over</source>
        <translation>Was der Ausbilder oder ein Fehlerplan in seinem Ring bewirkt hat und nicht vorbei ist</translation>
    </message>
    <message>
        <source>Device, OUT word, and when it was on the bus, whoever wrote it; not what stood there already</source>
        <translation>Teilnehmer, OUT-Wort und wann es auf dem Bus war, gleich wer es schrieb; nicht, was schon dort stand</translation>
    </message>
</context>
<context>
    <name>codewheel::SeatsView</name>
    <message>
        <source>Words of</source>
        <translation>Worte von</translation>
    </message>
    <message>
        <source>The device of each ring whose words the table shows (Alt+W)</source>
        <translation>Das Gerät jedes Rings, dessen Worte die Tabelle zeigt (Alt+W)</translation>
    </message>
    <message>
        <source>Sta&amp;rt seat afresh</source>
        <translation>Sitzplatz ne&amp;u starten</translation>
    </message>
    <message>
        <source>Gives the chosen seat a new ring, with factory settings and without what was written to it (Alt+R)</source>
        <translation>Gibt dem gewählten Sitzplatz einen neuen Ring, mit Werkseinstellungen und ohne das, was in ihn geschrieben wurde (Alt+U)</translation>
    </message>
    <message>
        <source>Seats</source>
        <translation>Sitzplätze</translation>
    </message>
    <message>
        <source>&amp;Words of</source>
        <translation>&amp;Worte von</translation>
    </message>
</context>
<context>
    <name>codewheel::SegmentModel</name>
    <message numerus="yes">
        <source>%n errors in the last five minutes</source>
        <translation>
            <numerusform>%n Fehler in den letzten fünf Minuten</numerusform>
            <numerusform>%n Fehler in den letzten fünf Minuten</numerusform>
        </translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>CRC-Fehler</translation>
    </message>
    <message>
        <source>Last error</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>5 minutes</source>
        <translation>5 Minuten</translation>
    </message>
    <message>
        <source>The CRC errors of the last five minutes, the newest at the right</source>
        <translation>Die CRC-Fehler der letzten fünf Minuten, die neuesten rechts</translation>
    </message>
    <message>
        <source>When the last CRC error was counted</source>
        <translation>Wann zuletzt ein CRC-Fehler gezählt wurde</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>codewheel::SequenceModel</name>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Sending</source>
        <translation>Sendet</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
</context>
<context>
    <name>codewheel::SequenceView</name>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>&amp;Unacknowledged words for</source>
        <translation>&amp;Unquittierte Worte für</translation>
    </message>
    <message>
        <source>No encoder is selected</source>
        <translation>Kein Geber gewählt</translation>
    </message>
    <message>
        <source>A sequence is a list of words that are sent to an encoder one after the other. Select an encoder in the bus structure.</source>
        <translation>Eine Sequenz ist eine Liste von Worten, die nacheinander an einen Geber gehen. Einen Geber im Busaufbau wählen.</translation>
    </message>
    <message>
        <source>Words to send</source>
        <translation>Zu sendende Worte</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Insert a word below</source>
        <translation>Ein Wort darunter einfügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected words</source>
        <translation>Die gewählten Worte entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move the word up</source>
        <translation>Das Wort nach oben schieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move the word down</source>
        <translation>Das Wort nach unten schieben</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Insert the column of words that was copied</source>
        <translation>Die kopierte Spalte von Worten einfügen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Read a sequence from a file</source>
        <translation>Eine Sequenz aus einer Datei lesen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source> cycles</source>
        <comment>unit of a number of bus cycles</comment>
        <translation> Zyklen</translation>
    </message>
    <message>
        <source>Cycles for words that nothing acknowledges</source>
        <translation>Zyklen für Worte, die nichts quittiert</translation>
    </message>
    <message>
        <source>Send the sequence</source>
        <translation>Die Sequenz senden</translation>
    </message>
    <message>
        <source>Stop the sequence</source>
        <translation>Die Sequenz anhalten</translation>
    </message>
    <message>
        <source>&amp;Run: end the parameterization with what the encoder has taken</source>
        <translation>&amp;Run: die Parametrierung mit dem beenden, was der Geber übernommen hat</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Sequenz öffnen</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Sequenzen (*.json)</translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation>Sequenz speichern</translation>
    </message>
    <message>
        <source>sequence.json</source>
        <translation>sequenz.json</translation>
    </message>
    <message>
        <source>%1 was not read. %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht gelesen. %2</translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht gespeichert: %2</translation>
    </message>
    <message numerus="yes">
        <source>All %n words were sent.</source>
        <translation>
            <numerusform>%n Wort wurde gesendet.</numerusform>
            <numerusform>Alle %n Worte wurden gesendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Sent before that: %2 of %3 words.</source>
        <comment>reason, counts</comment>
        <translation>%1 Davor gesendet: %2 von %3 Worten.</translation>
    </message>
    <message>
        <source>Add or paste words to send.</source>
        <translation>Worte zum Senden eingeben oder einfügen.</translation>
    </message>
    <message numerus="yes">
        <source>%n words to %1</source>
        <translation>
            <numerusform>%n Wort an %1</numerusform>
            <numerusform>%n Worte an %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Send the words to %1 one after the other, each until it is acknowledged</source>
        <translation>Die Worte nacheinander an %1 senden, jedes bis zur Quittung</translation>
    </message>
    <message>
        <source>%1 is on a serial line</source>
        <translation>%1 ist an einer seriellen Leitung</translation>
    </message>
    <message>
        <source>It takes requests instead of words. Type them in the terminal.</source>
        <translation>Er nimmt Anfragen statt Worten. Sie werden im Terminal eingetippt.</translation>
    </message>
    <message>
        <source>Open the terminal</source>
        <translation>Terminal öffnen</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 ist nicht verbunden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected words, or all, one a line</source>
        <translation>Kopiert die gewählten Worte oder alle, eines je Zeile</translation>
    </message>
    <message>
        <source>There are no words of %1 to take: nothing was sent to it, or the list is full.</source>
        <translation>Von %1 sind keine Worte zu übernehmen: Nichts wurde ihm gesendet, oder die Liste ist voll.</translation>
    </message>
    <message>
        <source>No words yet</source>
        <translation>Noch keine Worte</translation>
    </message>
    <message>
        <source>Save this sequence in a file</source>
        <translation>Diese Sequenz in einer Datei speichern</translation>
    </message>
    <message>
        <source>How long a word stays that nothing acknowledges; others stay until they are acknowledged</source>
        <translation>Wie lange ein Wort steht, das nichts quittiert; andere stehen bis zur Quittung</translation>
    </message>
    <message>
        <source>End the sequence, and choose in which state the encoder is left</source>
        <translation>Die Sequenz beenden und wählen, in welchem Zustand der Geber bleibt</translation>
    </message>
    <message>
        <source>&amp;Leave the encoder unchanged, OUT back to 0</source>
        <translation>Geber un&amp;verändert lassen, OUT zurück auf 0</translation>
    </message>
    <message>
        <source>Words can be sent to it once it is.</source>
        <translation>Worte lassen sich senden, sobald er verbunden ist.</translation>
    </message>
</context>
<context>
    <name>codewheel::ServedClientsModel</name>
    <message>
        <source>Client</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unit</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>Schreibvorgänge</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Wrote last</source>
        <translation>Schrieb zuletzt</translation>
    </message>
    <message>
        <source>Address and port of the client</source>
        <translation>Adresse und Port des Clients</translation>
    </message>
    <message>
        <source>When it connected</source>
        <translation>Wann er sich verbunden hat</translation>
    </message>
    <message>
        <source>The unit of its last request; with seats, its seat</source>
        <translation>Die Unit seiner letzten Anfrage; mit Sitzplätzen sein Sitzplatz</translation>
    </message>
    <message>
        <source>Requests so far</source>
        <translation>Anfragen bisher</translation>
    </message>
    <message>
        <source>Requests that wrote something, and were carried out</source>
        <translation>Anfragen, die etwas geschrieben haben und ausgeführt wurden</translation>
    </message>
    <message>
        <source>Requests that were answered with an exception</source>
        <translation>Anfragen, die mit einer Exception beantwortet wurden</translation>
    </message>
    <message>
        <source>Device, OUT word, and when it was on the bus</source>
        <translation>Teilnehmer, OUT-Wort und wann es auf dem Bus war</translation>
    </message>
</context>
<context>
    <name>codewheel::ServedRegistersModel</name>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>IN, input</source>
        <translation>IN, Input</translation>
    </message>
    <message>
        <source>IN, holding</source>
        <translation>IN, Holding</translation>
    </message>
    <message>
        <source>OUT, holding</source>
        <translation>OUT, Holding</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Number of the device in the ring</source>
        <translation>Nummer des Teilnehmers im Ring</translation>
    </message>
    <message>
        <source>Input registers of its IN word, counted from 0, high word first (function 4)</source>
        <translation>Input-Register seines IN-Wortes, ab 0 gezählt, oberes Wort zuerst (Funktion 4)</translation>
    </message>
    <message>
        <source>Holding registers that show its IN word too (functions 3 and 23)</source>
        <translation>Holding-Register, die sein IN-Wort auch zeigen (Funktionen 3 und 23)</translation>
    </message>
    <message>
        <source>Holding registers of its OUT word (functions 3, 6, 16, 22, 23)</source>
        <translation>Holding-Register seines OUT-Wortes (Funktionen 3, 6, 16, 22, 23)</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
</context>
<context>
    <name>codewheel::ServedText</name>
    <message>
        <source>%1 came, %2 refused</source>
        <comment>clients so far</comment>
        <translation>%1 kamen, %2 abgewiesen</translation>
    </message>
    <message>
        <source>Nobody is connected (%1).</source>
        <translation>Niemand ist verbunden (%1).</translation>
    </message>
    <message>
        <source>Connected: %1 (%2).</source>
        <translation>Verbunden: %1 (%2).</translation>
    </message>
</context>
<context>
    <name>codewheel::Server</name>
    <message>
        <source>Qt&apos;s driver for PostgreSQL is missing on this computer. Install the package libqt6sql6-psql.</source>
        <translation>Auf diesem Rechner fehlt der PostgreSQL-Treiber von Qt. Abhilfe: das Paket libqt6sql6-psql installieren.</translation>
    </message>
    <message>
        <source>there is no recording in it.</source>
        <translation>dort ist keine Aufzeichnung.</translation>
    </message>
    <message>
        <source>there are several recordings in it. Add ?recording=NAME; the newest are: %1.</source>
        <translation>dort sind mehrere Aufzeichnungen. ?recording=NAME anhängen; die neuesten sind: %1.</translation>
    </message>
    <message>
        <source>the server is too old: PostgreSQL 9.5 or newer is needed.</source>
        <translation>der Server ist zu alt: Nötig ist PostgreSQL 9.5 oder neuer.</translation>
    </message>
    <message>
        <source>its encoding is %1. Make a database with the encoding UTF8.</source>
        <translation>die Zeichenkodierung ist %1. Abhilfe: eine Datenbank mit der Kodierung UTF8 anlegen.</translation>
    </message>
    <message>
        <source>there is no recording %1 in it.</source>
        <translation>dort ist keine Aufzeichnung %1.</translation>
    </message>
    <message>
        <source>nothing of the recording has arrived as yet.</source>
        <translation>von der Aufzeichnung ist noch nichts angekommen.</translation>
    </message>
    <message>
        <source>the recording was made by a newer Codewheel.</source>
        <translation>die Aufzeichnung stammt von einem neueren Codewheel.</translation>
    </message>
    <message>
        <source>its user may not make a schema there. The owner of the database allows it with GRANT CREATE ON DATABASE.</source>
        <translation>der Benutzer darf dort kein Schema anlegen. Der Eigentümer der Datenbank erlaubt es mit GRANT CREATE ON DATABASE.</translation>
    </message>
    <message>
        <source>no computer of the name %1 is known.</source>
        <translation>ein Rechner mit dem Namen %1 ist nicht bekannt.</translation>
    </message>
    <message>
        <source>the server is just starting or stopping.</source>
        <translation>der Server startet oder endet gerade.</translation>
    </message>
    <message>
        <source>the server has no connection free.</source>
        <translation>der Server hat keine Verbindung mehr frei.</translation>
    </message>
    <message>
        <source>it asks for a password, and there is none. Put it into ~/.pgpass, into the file that PGPASSFILE names, or into PGPASSWORD.</source>
        <translation>der Server verlangt ein Passwort, und es ist keines da. Es gehört in ~/.pgpass, in die Datei, die PGPASSFILE nennt, oder in PGPASSWORD.</translation>
    </message>
    <message>
        <source>user or password is wrong. The password is in ~/.pgpass, in the file that PGPASSFILE names, or in PGPASSWORD.</source>
        <translation>Benutzer oder Passwort ist falsch. Das Passwort steht in ~/.pgpass, in der Datei, die PGPASSFILE nennt, oder in PGPASSWORD.</translation>
    </message>
    <message>
        <source>the server does not let this user of this computer in (pg_hba.conf).</source>
        <translation>der Server lässt diesen Benutzer von diesem Rechner aus nicht zu (pg_hba.conf).</translation>
    </message>
    <message>
        <source>the server has no database %1.</source>
        <translation>der Server hat keine Datenbank %1.</translation>
    </message>
    <message>
        <source>the server has no such user.</source>
        <translation>der Server hat keinen solchen Benutzer.</translation>
    </message>
    <message>
        <source>no server answers there. Is it running, and is the port right?</source>
        <translation>dort antwortet kein Server. Läuft er, und stimmt der Port?</translation>
    </message>
    <message>
        <source>its computer does not answer.</source>
        <translation>der Rechner des Servers antwortet nicht.</translation>
    </message>
    <message>
        <source>the connection was lost.</source>
        <translation>die Verbindung ist abgebrochen.</translation>
    </message>
    <message>
        <source>its user may not do that there: %1</source>
        <translation>der Benutzer darf das dort nicht: %1</translation>
    </message>
    <message>
        <source>the server only lets it be read.</source>
        <translation>der Server erlaubt nur das Lesen.</translation>
    </message>
    <message>
        <source>the disk of the server is full.</source>
        <translation>der Datenträger des Servers ist voll.</translation>
    </message>
    <message>
        <source>a table of the recording is missing.</source>
        <translation>eine Tabelle der Aufzeichnung fehlt.</translation>
    </message>
    <message>
        <source>The port is a number from 1 to 65535.</source>
        <translation>Der Port ist eine Zahl von 1 bis 65535.</translation>
    </message>
    <message>
        <source>The name of a recording has small letters, digits and underlines.</source>
        <translation>Der Name einer Aufzeichnung besteht aus kleinen Buchstaben, Ziffern und Unterstrichen.</translation>
    </message>
    <message>
        <source>Behind the question mark may stand sslmode, sslrootcert, connect_timeout and recording, each with a value, and &amp; between them.</source>
        <translation>Hinter dem Fragezeichen dürfen sslmode, sslrootcert, connect_timeout und recording stehen, jeweils mit einem Wert und mit &amp; dazwischen.</translation>
    </message>
    <message>
        <source>The value of %1 may have letters, digits and _ . / + -.</source>
        <translation>Der Wert von %1 darf Buchstaben, Ziffern und _ . / + - enthalten.</translation>
    </message>
    <message>
        <source>It begins with postgresql://.</source>
        <translation>Sie beginnt mit postgresql://.</translation>
    </message>
    <message>
        <source>The name of the database is missing: postgresql://HOST/DATABASE.</source>
        <translation>Der Name der Datenbank fehlt: postgresql://HOST/DATENBANK.</translation>
    </message>
    <message>
        <source>sending it takes longer.</source>
        <translation>das Senden dauert länger.</translation>
    </message>
    <message>
        <source>No computer can have this name: letters, digits and hyphens, with dots between its parts.</source>
        <translation>Kein Computer kann so heißen: Buchstaben, Ziffern und Bindestriche, mit Punkten zwischen den Teilen.</translation>
    </message>
    <message>
        <source>No database can have this name: it has more than %1 bytes.</source>
        <translation>Keine Datenbank kann so heißen: Der Name hat mehr als %1 Byte.</translation>
    </message>
</context>
<context>
    <name>codewheel::SettingField</name>
    <message>
        <source>&amp;Unit</source>
        <translation>Un&amp;it</translation>
    </message>
    <message>
        <source>The number of the device that has the registers; 1 with most gateways</source>
        <translation>Die Nummer des Geräts, das die Register hat; 1 bei den meisten Gateways</translation>
    </message>
    <message>
        <source>As set on the gateway; 19200 by the standard</source>
        <translation>Wie am Gateway eingestellt; 19200 nach der Norm</translation>
    </message>
    <message>
        <source>Data bits, parity and stop bits; 8E1 by the standard</source>
        <translation>Datenbits, Parität und Stoppbits; 8E1 nach der Norm</translation>
    </message>
    <message>
        <source>none</source>
        <comment>register</comment>
        <translation>keines</translation>
    </message>
    <message>
        <source>&amp;IN is in</source>
        <translation>I&amp;N steht in</translation>
    </message>
    <message>
        <source>Where the gateway shows what comes from the devices</source>
        <translation>Wo das Gateway zeigt, was von den Teilnehmern kommt</translation>
    </message>
    <message>
        <source>input registers (function 4)</source>
        <translation>Input-Registern (Funktion 4)</translation>
    </message>
    <message>
        <source>holding registers (function 3)</source>
        <translation>Holding-Registern (Funktion 3)</translation>
    </message>
    <message>
        <source>The register of the first device of the ring</source>
        <translation>Das Register des ersten Teilnehmers im Ring</translation>
    </message>
    <message>
        <source>First register of &amp;OUT</source>
        <translation>Erstes Register von O&amp;UT</translation>
    </message>
    <message>
        <source>OUT is in holding registers. The two areas must not overlap</source>
        <translation>OUT steht in Holding-Registern. Die beiden Bereiche dürfen sich nicht überschneiden</translation>
    </message>
    <message>
        <source>Function 23 also reads IN in the same transaction; for that IN must be in holding registers</source>
        <translation>Funktion 23 liest in derselben Transaktion auch IN; dafür muss IN in Holding-Registern stehen</translation>
    </message>
    <message>
        <source>function 16</source>
        <translation>Funktion 16</translation>
    </message>
    <message>
        <source>function 23, together with IN</source>
        <translation>Funktion 23, zusammen mit IN</translation>
    </message>
    <message>
        <source>Of the two registers of an encoder, for IN and OUT alike. The test shows which is right</source>
        <translation>Der beiden Register eines Gebers, für IN und OUT gleich. Der Test zeigt, welche stimmt</translation>
    </message>
    <message>
        <source>high word first</source>
        <translation>oberes Wort zuerst</translation>
    </message>
    <message>
        <source>low word first</source>
        <translation>unteres Wort zuerst</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Kept with the project; the program never writes it by itself</source>
        <translation>Steht im Projekt; das Programm schreibt es nie von sich aus</translation>
    </message>
    <message>
        <source> ms</source>
        <comment>unit of a time</comment>
        <translation> ms</translation>
    </message>
    <message>
        <source>From one exchange to the next; 0: as fast as the link is</source>
        <translation>Von einem Austausch zum nächsten; 0: so schnell, wie die Verbindung ist</translation>
    </message>
    <message>
        <source>How long the gateway needs to pass words on to the ring and back</source>
        <translation>Wie lange das Gateway braucht, um Worte an den Ring weiterzugeben und zurück</translation>
    </message>
    <message>
        <source>How long an answer is waited for</source>
        <translation>Wie lange auf eine Antwort gewartet wird</translation>
    </message>
    <message>
        <source>How often a request without a valid answer is repeated before the link counts as lost</source>
        <translation>Wie oft eine Anfrage ohne gültige Antwort wiederholt wird, bevor die Verbindung als unterbrochen gilt</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>First re&amp;gister of IN</source>
        <translation>E&amp;rstes Register von IN</translation>
    </message>
    <message>
        <source>OUT is written by</source>
        <translation>OUT schreibt</translation>
    </message>
    <message>
        <source>&amp;Word order</source>
        <translation>&amp;Wortreihenfolge</translation>
    </message>
    <message>
        <source>OUT is read back</source>
        <translation>OUT zurücklesen</translation>
    </message>
    <message>
        <source>Status register</source>
        <translation>Statusregister</translation>
    </message>
    <message>
        <source>Control register</source>
        <translation>Steuerregister</translation>
    </message>
    <message>
        <source>Poll interval</source>
        <translation>Abfrageintervall</translation>
    </message>
    <message>
        <source>Delay after an exchange</source>
        <translation>Pause nach einem Austausch</translation>
    </message>
    <message>
        <source>Time-out</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Number of retries</source>
        <translation>Anzahl der Wiederholungen</translation>
    </message>
    <message>
        <source>Copy time</source>
        <translation>Kopierzeit</translation>
    </message>
    <message>
        <source>How far apart the gateway may copy the two registers of a word: a new word counts once it has stood that long</source>
        <translation>Wie weit auseinander das Gateway die zwei Register eines Wortes kopieren darf: Ein neues Wort zählt, wenn es so lange gestanden hat</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Geduld</translation>
    </message>
    <message>
        <source>How long the gateway may say that it is busy before the link counts as lost</source>
        <translation>Wie lange das Gateway melden darf, dass es beschäftigt ist, bevor die Verbindung als verloren gilt</translation>
    </message>
    <message>
        <source>Where the gateway tells its state, if it does; what its bits mean is set below</source>
        <translation>Wo das Gateway seinen Zustand nennt, falls es das tut; was die Bits bedeuten, steht darunter</translation>
    </message>
    <message>
        <source>Bit of run</source>
        <translation>Bit für Lauf</translation>
    </message>
    <message>
        <source>The bit of the status register that is 1 while the ring runs, by the manual of the gateway. Without it the program cannot know</source>
        <translation>Das Bit des Statusregisters, das nach dem Handbuch des Gateways 1 ist, solange der Ring läuft. Ohne es kann das Programm das nicht wissen</translation>
    </message>
    <message>
        <source>Bits of a fault</source>
        <translation>Bits für Fehler</translation>
    </message>
    <message>
        <source>Register of the place</source>
        <translation>Register des Orts</translation>
    </message>
    <message>
        <source>Where the gateway tells the place of a fault: segment in the high byte, position in the low one</source>
        <translation>Wo das Gateway den Ort eines Fehlers nennt: Segment im oberen Byte, Position im unteren</translation>
    </message>
    <message>
        <source>Registers in a read</source>
        <translation>Register je Lesen</translation>
    </message>
    <message>
        <source>The most that the gateway gives in one request; 125 by the standard</source>
        <translation>So viele, wie das Gateway höchstens in einer Anfrage liefert; 125 nach der Norm</translation>
    </message>
    <message>
        <source>Registers in a write</source>
        <translation>Register je Schreiben</translation>
    </message>
    <message>
        <source>The most that the gateway takes in one request; 123 by the standard</source>
        <translation>So viele, wie das Gateway höchstens in einer Anfrage nimmt; 123 nach der Norm</translation>
    </message>
    <message>
        <source>Watchdog register</source>
        <translation>Watchdog-Register</translation>
    </message>
    <message>
        <source>The holding register that acknowledges a watchdog of the gateway that has tripped; it is written when you say so</source>
        <translation>Das Holding-Register, das einen angesprochenen Watchdog des Gateways quittiert; es wird geschrieben, wenn Sie es sagen</translation>
    </message>
    <message>
        <source>Value for it</source>
        <translation>Wert dafür</translation>
    </message>
    <message>
        <source>What acknowledges the watchdog, by the manual of the gateway</source>
        <translation>Was den Watchdog nach dem Handbuch des Gateways quittiert</translation>
    </message>
    <message>
        <source>Before each write, so that it is noticed if somebody else writes too. No: it is not</source>
        <translation>Vor jedem Schreiben, damit auffällt, wenn noch jemand schreibt. Nein: Es fällt nicht auf</translation>
    </message>
    <message>
        <source>The bits of the status register of which one is 1 when the ring has failed, as 2+3; empty: none</source>
        <translation>Die Bits des Statusregisters, von denen eines 1 ist, wenn der Ring ausgefallen ist, etwa 2+3; leer: keines</translation>
    </message>
</context>
<context>
    <name>codewheel::SettingsAtWork</name>
    <message>
        <source>Settings of the window</source>
        <translation>Einstellungen des Fensters</translation>
    </message>
    <message>
        <source>Messages and account of EEPROM writes</source>
        <translation>Meldungen und Zählung der EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>Your own device descriptions</source>
        <translation>Eigene Gerätebeschreibungen</translation>
    </message>
    <message>
        <source>Unsaved changes, kept in case of a crash</source>
        <translation>Nicht gespeicherte Änderungen, für den Fall eines Absturzes</translation>
    </message>
</context>
<context>
    <name>codewheel::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Zahlen</translation>
    </message>
    <message>
        <source>Decimal point: 0.25</source>
        <translation>Dezimalpunkt: 0.25</translation>
    </message>
    <message>
        <source>Decimal comma: 0,25</source>
        <translation>Dezimalkomma: 0,25</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Light or dark, or as the desktop is.</source>
        <translation>Hell oder dunkel, oder wie der Desktop.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Large &amp;controls</source>
        <translation>&amp;Große Bedienelemente</translation>
    </message>
    <message>
        <source>Bits and buttons are 1.5 times as large, for gloves.</source>
        <translation>Bits und Tasten sind 1,5-mal so groß, für Handschuhe.</translation>
    </message>
    <message>
        <source>Less &amp;motion</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Panels are not animated. Values always change at once.</source>
        <translation>Felder werden nicht animiert. Werte ändern sich immer sofort.</translation>
    </message>
    <message>
        <source>&amp;Frames a second</source>
        <translation>&amp;Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>How often values are painted. Fewer spare the processor; the bus is not slower, and no change of a bit is lost.</source>
        <translation>Wie oft Werte gezeichnet werden. Weniger Bilder schonen den Prozessor; der Bus wird nicht langsamer, und keine Änderung eines Bits geht verloren.</translation>
    </message>
    <message>
        <source>EEPROM</source>
        <translation>EEPROM</translation>
    </message>
    <message>
        <source>&amp;Ask from</source>
        <translation>&amp;Rückfrage ab</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent of the writes the manual speaks of</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>&amp;Messages, at most</source>
        <translation>&amp;Meldungen, höchstens</translation>
    </message>
    <message>
        <source> MB</source>
        <comment>megabytes</comment>
        <translation> MB</translation>
    </message>
    <message>
        <source> rows</source>
        <comment>of a table</comment>
        <translation> Zeilen</translation>
    </message>
    <message>
        <source>&amp;Unsaved changes, every</source>
        <translation>&amp;Nicht Gespeichertes, alle</translation>
    </message>
    <message>
        <source> s</source>
        <comment>seconds</comment>
        <translation> s</translation>
    </message>
    <message>
        <source>The folders follow XDG_CONFIG_HOME and XDG_DATA_HOME of the system, so that window and command line share one account of EEPROM writes; they are not changed here.</source>
        <translation>Die Ordner richten sich nach XDG_CONFIG_HOME und XDG_DATA_HOME des Systems, damit Fenster und Kommandozeile eine gemeinsame Zählung der EEPROM-Schreibvorgänge haben; sie werden nicht hier geändert.</translation>
    </message>
    <message>
        <source>Keeps what is set</source>
        <translation>Behält, was eingestellt ist</translation>
    </message>
    <message>
        <source>Restores what was set before (Esc)</source>
        <translation>Stellt wieder her, was vorher eingestellt war (Esc)</translation>
    </message>
    <message>
        <source>Language and appearance</source>
        <translation>Sprache und Aussehen</translation>
    </message>
    <message>
        <source>Of all texts. The window is rebuilt; the buses keep running.</source>
        <translation>Aller Texte. Das Fenster wird neu aufgebaut; die Busse laufen weiter.</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>As usual in the language</source>
        <translation>Wie in der Sprache üblich</translation>
    </message>
    <message>
        <source>From this share of the writes stated in an encoder&apos;s manual, each write has to be confirmed. It cannot be above the usual 75 %. Beyond what the manual guarantees, the place always has to be typed.</source>
        <translation>Ab diesem Anteil der im Handbuch eines Gebers genannten Schreibvorgänge ist jedes Schreiben zu bestätigen. Er kann nicht über den üblichen 75 % liegen. Jenseits dessen, was das Handbuch garantiert, ist immer der Platz einzutippen.</translation>
    </message>
    <message>
        <source>Beyond this, the oldest messages are dropped. Takes effect at the next start.</source>
        <translation>Darüber hinaus fallen die ältesten Meldungen weg. Wirkt beim nächsten Start.</translation>
    </message>
    <message>
        <source>How often unsaved changes are kept in case of a crash. They are offered at the next start until they are recovered or discarded.</source>
        <translation>Wie oft nicht Gespeichertes für den Fall eines Absturzes aufgehoben wird. Beim nächsten Start wird es angeboten, bis es wiederhergestellt oder verworfen ist.</translation>
    </message>
    <message>
        <source>Sets everything as it is after installation; Cancel undoes that</source>
        <translation>Stellt alles ein wie nach der Installation; Abbrechen nimmt das zurück</translation>
    </message>
    <message>
        <source>&amp;Trend, at most</source>
        <translation>&amp;Trend, höchstens</translation>
    </message>
    <message>
        <source>Memory for what all encoders have shown while the program runs; the oldest is dropped. How far back it goes is shown on the page of the trend.</source>
        <translation>Speicher für das, was alle Geber gezeigt haben, solange das Programm läuft; das Älteste wird verworfen. Wie weit es zurückreicht, steht auf der Seite des Trends.</translation>
    </message>
    <message>
        <source>&amp;Handshake trace and terminal, at most</source>
        <translation>&amp;Handshake-Protokoll und Terminal, höchstens</translation>
    </message>
    <message>
        <source>Kept for each encoder, and in the terminal of each serial line, while the program runs; the oldest are dropped.</source>
        <translation>Je Geber, und im Terminal je serieller Leitung, solange das Programm läuft; die ältesten entfallen.</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Störungen</translation>
    </message>
    <message>
        <source>&amp;Notify of faults while another program is in front</source>
        <translation>Störungen &amp;melden, während ein anderes Programm vorn ist</translation>
    </message>
    <message>
        <source>A notice on the desktop says what has failed and where. Several in a short time are put together.</source>
        <translation>Eine Meldung des Desktops sagt, was gestört ist und wo. Mehrere in kurzer Zeit werden zusammengefasst.</translation>
    </message>
    <message>
        <source>With a &amp;sound</source>
        <translation>Mit &amp;Ton</translation>
    </message>
    <message>
        <source>The desktop plays its sound for errors; where it has none, the program beeps.</source>
        <translation>Der Desktop spielt seinen Ton für Fehler; hat er keinen, gibt das Programm einen Signalton.</translation>
    </message>
    <message>
        <source>Your &amp;name</source>
        <translation>Eigener &amp;Name</translation>
    </message>
    <message>
        <source>Entered with each EEPROM write, beside the name of this computer, in the window and on the command line. May stay empty.</source>
        <translation>Wird zu jedem EEPROM-Schreibvorgang eingetragen, neben dem Namen dieses Rechners, im Fenster und auf der Kommandozeile. Kann leer bleiben.</translation>
    </message>
    <message>
        <source>The sign before decimals. The other one may be typed too, but not before three digits.</source>
        <translation>Das Zeichen vor den Nachkommastellen. Das andere darf auch getippt werden, aber nicht vor drei Ziffern.</translation>
    </message>
</context>
<context>
    <name>codewheel::Setup</name>
    <message>
        <source>Values wanted for %1</source>
        <translation>Gewünschte Werte für %1</translation>
    </message>
    <message>
        <source>Wizard for %1 cancelled</source>
        <translation>Assistent für %1 abgebrochen</translation>
    </message>
</context>
<context>
    <name>codewheel::ShaftConsequences</name>
    <message>
        <source>Resolution and range are shown once steps, revolutions and direction are known or wanted.</source>
        <translation>Auflösung und Bereich lassen sich bestimmen, sobald Schritte, Umdrehungen und Zählrichtung bekannt oder gewünscht sind.</translation>
    </message>
    <message>
        <source>What it will read here is not known, since the zero offset or the scale is not.</source>
        <translation>Was er hier zeigen wird, ist nicht bestimmbar: Nullpunkt-Verschiebung oder Skalierung ist unbekannt.</translation>
    </message>
    <message>
        <source>Resolution %1 steps per turn, total range %2 steps over %3 turns.</source>
        <translation>Auflösung %1 Schritte je Umdrehung, Gesamtbereich %2 Schritte über %3 Umdrehungen.</translation>
    </message>
</context>
<context>
    <name>codewheel::ShaftControls</name>
    <message>
        <source>Raw position</source>
        <translation>Rohposition</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>Raw position to turn to</source>
        <translation>Rohposition, auf die gedreht wird</translation>
    </message>
    <message>
        <source>Raw position, in the encoder&apos;s own steps; Enter turns the shaft to it</source>
        <translation>Rohposition in Schritten des Gebers; Eingabe dreht die Welle dorthin</translation>
    </message>
    <message>
        <source>Turn to the raw position</source>
        <translation>Auf die Rohposition drehen</translation>
    </message>
    <message>
        <source>Turn to</source>
        <translation>Drehen auf</translation>
    </message>
    <message>
        <source>Speed in revolutions per minute</source>
        <translation>Drehzahl in Umdrehungen pro Minute</translation>
    </message>
    <message>
        <source>Revolutions per minute; positive is clockwise, looking at the shaft</source>
        <translation>Umdrehungen pro Minute; positiv ist rechtsherum, mit Blick auf die Welle</translation>
    </message>
    <message>
        <source>Stop the shaft</source>
        <translation>Die Welle anhalten</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Drehzahl, U/min</translation>
    </message>
</context>
<context>
    <name>codewheel::ShaftDial</name>
    <message>
        <source>Not known: %1. The disc needs it to turn.</source>
        <translation>Unbekannt: %1. Ohne das dreht sich die Scheibe nicht.</translation>
    </message>
    <message>
        <source>The steps per turn of this encoder are not described: the disc cannot turn.</source>
        <translation>Die Schritte je Umdrehung dieses Gebers sind nicht beschrieben: Die Scheibe kann sich nicht drehen.</translation>
    </message>
    <message>
        <source>The position comes in Gray code.</source>
        <translation>Die Position kommt im Gray-Code.</translation>
    </message>
    <message>
        <source>The position is signed.</source>
        <translation>Die Position hat ein Vorzeichen.</translation>
    </message>
    <message>
        <source>No speed: positions come so seldom that the shaft may make a whole turn between two.</source>
        <translation>Keine Drehzahl: Die Positionen kommen so selten, dass die Welle zwischen zweien eine ganze Umdrehung machen kann.</translation>
    </message>
</context>
<context>
    <name>codewheel::ShiftBar</name>
    <message>
        <source>Shown later by</source>
        <translation>Später gezeigt um</translation>
    </message>
    <message>
        <source>How many seconds later than it was this recording is shown, to compare it with other curves; below 0: earlier</source>
        <translation>Um wie viele Sekunden später diese Aufzeichnung gezeigt wird, um sie mit anderen Kurven zu vergleichen; unter 0: früher</translation>
    </message>
    <message>
        <source>Shifts the recording so that it begins where the other curves begin</source>
        <translation>Verschiebt die Aufzeichnung so, dass sie dort beginnt, wo die anderen Kurven beginnen</translation>
    </message>
    <message>
        <source>Shifts the recording so that what is at cursor A comes to lie at cursor B</source>
        <translation>Verschiebt die Aufzeichnung so, dass das, was bei Cursor A liegt, zu Cursor B kommt</translation>
    </message>
    <message>
        <source>Shows the recording at the time it was made</source>
        <translation>Zeigt die Aufzeichnung zu der Zeit, zu der sie entstand</translation>
    </message>
    <message>
        <source>Show moment</source>
        <translation>Moment zeigen</translation>
    </message>
    <message>
        <source>Monitor, dial and parameters show the moment of the recording that is at the cursor</source>
        <translation>Monitor, Scheibe und Parameter zeigen den Moment der Aufzeichnung, der beim Cursor liegt</translation>
    </message>
    <message>
        <source> s later</source>
        <translation> s später</translation>
    </message>
    <message>
        <source>&amp;Recording:</source>
        <translation>&amp;Aufzeichnung:</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Shifts the recording so that it lies on other curves</source>
        <translation>Verschiebt die Aufzeichnung, so dass sie auf anderen Kurven liegt</translation>
    </message>
    <message>
        <source>&amp;Begin together</source>
        <translation>Gleicher &amp;Beginn</translation>
    </message>
    <message>
        <source>Cursor &amp;A to B</source>
        <translation>Cursor &amp;A auf B</translation>
    </message>
    <message>
        <source>As &amp;recorded</source>
        <translation>&amp;Wie aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>codewheel::SpinField</name>
    <message>
        <source>%1 is outside %2 to %3.</source>
        <translation>%1 liegt außerhalb von %2 bis %3.</translation>
    </message>
</context>
<context>
    <name>codewheel::Start</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Replace an encoder: choose its place in the bus structure.</source>
        <translation>Geber ersetzen: seinen Platz im Busaufbau wählen.</translation>
    </message>
    <message>
        <source>&amp;Replace the chosen one</source>
        <translation>Den gewählten &amp;ersetzen</translation>
    </message>
    <message>
        <source>Replace an encoder: connect the bus that the new encoder is on.</source>
        <translation>Geber ersetzen: den Bus verbinden, an dem der neue Geber steht.</translation>
    </message>
</context>
<context>
    <name>codewheel::StartPage</name>
    <message>
        <source>Training bus</source>
        <translation>Übungsbus</translation>
    </message>
    <message>
        <source>Simulated encoders on a ring and a serial line, to try everything without hardware.</source>
        <translation>Simulierte Geber an einem Ring und einer seriellen Leitung, zum Ausprobieren ohne Hardware.</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Looks at the encoders of a bus. Nothing is written.</source>
        <translation>Zeigt die Geber eines Busses. Nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt benutzte Projekte</translation>
    </message>
    <message>
        <source>Goes to the projects that were open last</source>
        <translation>Geht zu den zuletzt geöffneten Projekten</translation>
    </message>
    <message>
        <source>Replace an encoder</source>
        <translation>Geber ersetzen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>No bus is connected</source>
        <translation>Kein Bus ist verbunden</translation>
    </message>
    <message>
        <source>Return opens the chosen project, Del takes it off the list.</source>
        <translation>Eingabe öffnet das gewählte Projekt, Entf nimmt es aus der Liste.</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Takes the chosen project off the list (Del); its file stays</source>
        <translation>Nimmt das gewählte Projekt aus der Liste (Entf); seine Datei bleibt</translation>
    </message>
    <message>
        <source>Nothing is connected or sent until you ask for it.</source>
        <translation>Ohne Ihr Zutun wird nichts verbunden oder gesendet.</translation>
    </message>
    <message>
        <source>The project %1 is open. Nothing is connected or sent until you ask for it.</source>
        <translation>Das Projekt %1 ist geöffnet. Ohne Ihr Zutun wird nichts verbunden oder gesendet.</translation>
    </message>
    <message>
        <source>Reopen %1</source>
        <translation>%1 wieder öffnen</translation>
    </message>
    <message>
        <source>The project of the last session, %1</source>
        <translation>Das Projekt der letzten Sitzung, %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The planned encoders, with the values they should have.</source>
        <translation>Die geplanten Geber, mit den Werten, die sie haben sollen.</translation>
    </message>
    <message>
        <source>Gives a new encoder the values and the position of the previous one, from the project.</source>
        <translation>Überträgt Werte und Position des alten Gebers aus dem Projekt auf den neuen.</translation>
    </message>
    <message>
        <source>Who is there?</source>
        <translation>Wer ist da?</translation>
    </message>
    <message>
        <source>Listens at ports and hosts for encoders and gateways, and connects with the settings found.</source>
        <translation>Horcht an Anschlüssen und Hosts nach Gebern und Gateways und verbindet mit den gefundenen Einstellungen.</translation>
    </message>
    <message>
        <source>%1: key %2</source>
        <translation>%1: Taste %2</translation>
    </message>
</context>
<context>
    <name>codewheel::StatusBits</name>
    <message>
        <source>Diagnostic status register</source>
        <translation>Diagnosestatusregister</translation>
    </message>
    <message>
        <source>The diagnostic status register; healthy in RUN: 00E0h</source>
        <translation>Das Diagnosestatusregister; in RUN fehlerfrei: 00E0h</translation>
    </message>
    <message>
        <source>Bit %1, %2: %3</source>
        <translation>Bit %1, %2: %3</translation>
    </message>
    <message>
        <source>%1 is set</source>
        <translation>%1 ist gesetzt</translation>
    </message>
    <message>
        <source>%1 is not set</source>
        <translation>%1 ist nicht gesetzt</translation>
    </message>
</context>
<context>
    <name>codewheel::StatusLine</name>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>EEPROM writes</source>
        <translation>EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>Writes to the memory of the chosen encoder by this program since it was started</source>
        <translation>Schreibvorgänge dieses Programms in den Speicher des gewählten Gebers seit dem Programmstart</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <comment>place, make: writes</comment>
        <translation>%1 %2: %3</translation>
    </message>
    <message>
        <source>State of the bus</source>
        <translation>Zustand des Busses</translation>
    </message>
    <message>
        <source>Watch: nothing is written. Operate: writing is allowed.</source>
        <translation>Beobachten: Nichts wird geschrieben. Bedienen: Schreiben ist erlaubt.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <comment>fault of a bus</comment>
        <translation>
            <numerusform>%1 und %n weiterer</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: recording</source>
        <comment>bus</comment>
        <translation>%1: Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>codewheel::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>codewheel::StepTable</name>
    <message>
        <source>next</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>Back to normal running</source>
        <translation>Zurück zum Normalbetrieb</translation>
    </message>
    <message>
        <source>Run: the values become valid</source>
        <translation>Run: Die Werte werden gültig</translation>
    </message>
    <message>
        <source>Set the position to the preset</source>
        <translation>Position auf den Preset setzen</translation>
    </message>
    <message>
        <source>Read whether the encoder counts steps minus 1</source>
        <translation>Auslesen, ob der Geber Schritte minus 1 zählt</translation>
    </message>
    <message>
        <source>Read %1</source>
        <translation>Auslesen: %1</translation>
    </message>
    <message>
        <source>Read out</source>
        <translation>Auslesen</translation>
    </message>
    <message>
        <source>End the read-out</source>
        <translation>Auslesen beenden</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>OUT</source>
        <translation>OUT</translation>
    </message>
    <message>
        <source>IN</source>
        <translation>IN</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Set the position to the preset, for one bus cycle</source>
        <translation>Position auf den Preset setzen, einen Buszyklus lang</translation>
    </message>
    <message>
        <source>Take the service bit back</source>
        <translation>Das Dienst-Bit zurücknehmen</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
</context>
<context>
    <name>codewheel::StructureEditor</name>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>hits of a search</comment>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n devices with findings</source>
        <translation>
            <numerusform>%n Teilnehmer mit Befund</numerusform>
            <numerusform>%n Teilnehmer mit Befunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert a device</source>
        <translation>Gerät einfügen</translation>
    </message>
    <message>
        <source>Insert a device from the catalog or by ID code</source>
        <translation>Gerät aus dem Katalog oder nach ID-Code einfügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen devices with all that hangs below</source>
        <translation>Die gewählten Teilnehmer mit allem darunter entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move before its neighbour</source>
        <translation>Vor den Nachbarn schieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move behind its neighbour</source>
        <translation>Hinter den Nachbarn schieben</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Hinein</translation>
    </message>
    <message>
        <source>Hang it below the bus terminal before it</source>
        <translation>Unter die Busklemme davor hängen</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Heraus</translation>
    </message>
    <message>
        <source>Take it out, behind its bus terminal</source>
        <translation>Herausnehmen, hinter seine Busklemme</translation>
    </message>
    <message>
        <source>Local bus or branch</source>
        <translation>Lokalbus oder Abzweig</translation>
    </message>
    <message>
        <source>From the local bus of its bus terminal into the branch, and back</source>
        <translation>Vom Lokalbus seiner Busklemme in den Abzweig und zurück</translation>
    </message>
    <message>
        <source>Number, name, ID code, station</source>
        <translation>Nummer, Name, ID-Code, Station</translation>
    </message>
    <message>
        <source>Search the structure</source>
        <translation>Aufbau durchsuchen</translation>
    </message>
    <message>
        <source>Planned bus structure</source>
        <translation>Geplanter Busaufbau</translation>
    </message>
    <message>
        <source>Goes to the next device with a finding (F3)</source>
        <translation>Geht zum nächsten Teilnehmer mit einem Befund (F3)</translation>
    </message>
    <message>
        <source>No findings</source>
        <translation>Keine Befunde</translation>
    </message>
    <message>
        <source>Drag devices to move them. F2 or a double click edits station, group, serial number, note and addresses.</source>
        <translation>Geräte ziehen, um sie zu verschieben. F2 oder ein Doppelklick bearbeitet Station, Gruppe, Seriennummer, Notiz und Adressen.</translation>
    </message>
    <message>
        <source>not planned yet</source>
        <translation>noch nicht geplant</translation>
    </message>
    <message>
        <source>F2 or a double click edits address, station, group, serial number and note.</source>
        <translation>F2 oder ein Doppelklick bearbeitet Adresse, Station, Gruppe, Seriennummer und Notiz.</translation>
    </message>
    <message>
        <source>Address, name, station</source>
        <translation>Adresse, Name, Station</translation>
    </message>
    <message>
        <source>Planned b&amp;us</source>
        <translation>Geplanter B&amp;us</translation>
    </message>
    <message>
        <source>Planned bus</source>
        <translation>Geplanter Bus</translation>
    </message>
    <message>
        <source>The bus that is planned here; choosing a device elsewhere chooses its bus, too</source>
        <translation>Der Bus, der hier geplant wird; wer anderswo ein Gerät wählt, wählt auch dessen Bus</translation>
    </message>
    <message>
        <source>Insert the first one, or connect the bus and take it over.</source>
        <translation>Das erste einfügen, oder den Bus verbinden und den Aufbau übernehmen.</translation>
    </message>
    <message>
        <source>Bus structure</source>
        <translation>Busaufbau</translation>
    </message>
    <message>
        <source>Edits the planned bus. Nothing is sent here.</source>
        <translation>Bearbeitet den geplanten Bus. Hier wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Insert…</source>
        <translation>Einfügen…</translation>
    </message>
    <message>
        <source>Goes to the devices with this text; Enter and Shift+Enter to the next and the previous one (Ctrl+F)</source>
        <translation>Geht zu den Teilnehmern mit diesem Text; Eingabe und Umschalt+Eingabe zum nächsten und zum vorigen (Strg+F)</translation>
    </message>
    <message>
        <source>No devices are planned</source>
        <translation>Keine Geräte sind geplant</translation>
    </message>
    <message>
        <source>%1, not planned yet</source>
        <translation>%1, noch nicht geplant</translation>
    </message>
</context>
<context>
    <name>codewheel::StructureModel</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>ID code</source>
        <translation>ID-Code</translation>
    </message>
    <message>
        <source>Words IN / OUT</source>
        <translation>Worte IN / OUT</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>%1, not up to date</source>
        <comment>a position</comment>
        <translation>%1, nicht aktuell</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation>%1 U/min</translation>
    </message>
    <message>
        <source>%1, the bus is interrupted before it</source>
        <translation>%1, davor ist der Bus unterbrochen</translation>
    </message>
    <message>
        <source>Double click or Enter: why there is no data</source>
        <translation>Doppelklick oder Eingabe: warum keine Daten kommen</translation>
    </message>
    <message>
        <source>Click on the state: why it is so</source>
        <translation>Klick auf den Zustand: warum es so ist</translation>
    </message>
</context>
<context>
    <name>codewheel::StructureView</name>
    <message>
        <source>Bus structure</source>
        <translation>Busaufbau</translation>
    </message>
    <message>
        <source>The bus does not say which make %1 is.</source>
        <translation>Der Bus sagt nicht, von welchem Hersteller %1 ist.</translation>
    </message>
    <message>
        <source>Name it</source>
        <translation>Benennen</translation>
    </message>
    <message>
        <source>The project has no devices yet.</source>
        <translation>Das Projekt hat noch keine Teilnehmer.</translation>
    </message>
    <message>
        <source>No bus is connected</source>
        <translation>Kein Bus ist verbunden</translation>
    </message>
    <message>
        <source>Choose a device to see it in the panels. Enter opens its monitors, or says what is wrong with one in red; dragged onto the monitors, it is pinned there.</source>
        <translation>Ein Gerät wählen, um es in den Bereichen zu sehen. Eingabe öffnet seine Monitore oder sagt, was bei einem roten nicht stimmt; auf die Monitore gezogen, wird es dort angeheftet.</translation>
    </message>
</context>
<context>
    <name>codewheel::Support</name>
    <message>
        <source>The newest messages, %1 at most</source>
        <translation>Die neuesten Meldungen, höchstens %1</translation>
    </message>
    <message>
        <source>Handshake trace of %1</source>
        <translation>Handshake-Protokoll von %1</translation>
    </message>
    <message>
        <source>Versions of program and system, language, screens</source>
        <translation>Versionen von Programm und System, Sprache, Bildschirme</translation>
    </message>
    <message>
        <source>Serial ports and their adapters</source>
        <translation>Serielle Schnittstellen und ihre Adapter</translation>
    </message>
    <message>
        <source>Buses, their states and devices</source>
        <translation>Busse, ihre Zustände und Geräte</translation>
    </message>
    <message>
        <source>The project as it is now, unsaved changes included</source>
        <translation>Das Projekt, wie es jetzt ist, mit dem, was nicht gespeichert ist</translation>
    </message>
</context>
<context>
    <name>codewheel::SupportDialog</name>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>Goes into the file as message.txt; may be left empty</source>
        <translation>Kommt als message.txt in die Datei; darf leer bleiben</translation>
    </message>
    <message>
        <source>What did you do, what happened, what should have happened?</source>
        <translation>Was wurde getan, was ist geschehen, was hätte geschehen sollen?</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Collect for support</source>
        <translation>Für den Support sammeln</translation>
    </message>
    <message>
        <source>Asks where to save the file; nothing is sent</source>
        <translation>Fragt, wohin die Datei soll; es wird nichts gesendet</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>What will be in the file; what is not ticked is left out (Space)</source>
        <translation>Was in die Datei kommt; was nicht angehakt ist, bleibt weg (Leertaste)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Save for support</source>
        <translation>Für den Support speichern</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip-Dateien (*.zip)</translation>
    </message>
    <message>
        <source>What the chosen file contains</source>
        <translation>Was in der gewählten Datei steht</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>What it contains</source>
        <translation>Was darin steht</translation>
    </message>
    <message numerus="yes">
        <source>%n files, %1 uncompressed</source>
        <translation>
            <numerusform>%n Datei, %1 unkomprimiert</numerusform>
            <numerusform>%n Dateien, %1 unkomprimiert</numerusform>
        </translation>
    </message>
    <message>
        <source>One file with what is needed to look into a problem. It holds what is ticked here and nothing else. The home folder, the user name in paths and the name of this computer are removed. Nothing is sent: whom you give the file to is up to you.</source>
        <translation>Eine Datei mit dem, was zur Klärung eines Problems nötig ist. Sie enthält, was hier angehakt ist, und sonst nichts. Persönlicher Ordner, Benutzername in Pfaden und Name dieses Rechners sind entfernt. Es wird nichts gesendet: Die Datei kann weitergeben, wer will.</translation>
    </message>
</context>
<context>
    <name>codewheel::TablesReader</name>
    <message>
        <source>At least one row is expected here.</source>
        <translation>Hier wird mindestens eine Zeile erwartet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be on and blink.</source>
        <translation>„%1“ kann nicht zugleich leuchten und blinken.</translation>
    </message>
    <message>
        <source>This is here twice.</source>
        <translation>Das steht hier doppelt.</translation>
    </message>
</context>
<context>
    <name>codewheel::ThenMark</name>
    <message>
        <source>now %1</source>
        <comment>position</comment>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>then: not known</source>
        <comment>position</comment>
        <translation>danach: nicht bekannt</translation>
    </message>
    <message>
        <source>then %1</source>
        <comment>position</comment>
        <translation>danach %1</translation>
    </message>
</context>
<context>
    <name>codewheel::TraceView</name>
    <message>
        <source>No encoder is selected</source>
        <translation>Kein Geber gewählt</translation>
    </message>
    <message>
        <source>The handshake trace has a row for each change of the words of an encoder. Select an encoder in the bus structure.</source>
        <translation>Das Handshake-Protokoll hat eine Zeile für jede Änderung der Worte eines Gebers. Einen Geber im Busaufbau wählen.</translation>
    </message>
    <message>
        <source>Handshake trace</source>
        <translation>Handshake-Protokoll</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keep the newest row in view</source>
        <translation>Automatisch folgen: Die neueste Zeile bleibt im Blick</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with tabs between the columns</source>
        <translation>Die gewählten Zeilen oder alle kopieren, mit Tabulatoren zwischen den Spalten</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Save all rows as a CSV file</source>
        <translation>Alle Zeilen als CSV-Datei speichern</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove all rows of this encoder</source>
        <translation>Alle Zeilen dieses Gebers entfernen</translation>
    </message>
    <message>
        <source>Export the trace</source>
        <translation>Handshake-Protokoll exportieren</translation>
    </message>
    <message>
        <source>trace.csv</source>
        <translation>protokoll.csv</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>%1 is on a serial line</source>
        <translation>%1 ist an einer seriellen Leitung</translation>
    </message>
    <message>
        <source>Open the terminal</source>
        <translation>Terminal öffnen</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Show the rows again that Clear removed</source>
        <translation>Die mit Leeren entfernten Zeilen wieder zeigen</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 ist nicht verbunden</translation>
    </message>
    <message>
        <source>Hold the table; new rows are kept and shown afterwards</source>
        <translation>Die Tabelle anhalten; neue Zeilen bleiben erhalten und erscheinen danach</translation>
    </message>
    <message>
        <source>It has no words. The traffic of its line is in the terminal.</source>
        <translation>Er hat keine Worte. Was über seine Leitung geht, steht im Terminal.</translation>
    </message>
    <message>
        <source>What passes is shown once it is.</source>
        <translation>Was gesendet und empfangen wird, erscheint hier, sobald er verbunden ist.</translation>
    </message>
</context>
<context>
    <name>codewheel::TrackText</name>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>IN bit %1</source>
        <translation>IN Bit %1</translation>
    </message>
    <message>
        <source>OUT bit %1</source>
        <translation>OUT Bit %1</translation>
    </message>
    <message>
        <source>cam %1</source>
        <translation>Nocken %1</translation>
    </message>
    <message>
        <source>cams</source>
        <translation>Nocken</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>steps/s</source>
        <translation>Schritte/s</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>U/min</translation>
    </message>
</context>
<context>
    <name>codewheel::TrafficModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>%1, typed</source>
        <comment>sent, answer ...</comment>
        <translation>%1, getippt</translation>
    </message>
    <message>
        <source>Since last, ms</source>
        <translation>Seit letzter, ms</translation>
    </message>
    <message numerus="yes">
        <source>%Ln rows</source>
        <translation>
            <numerusform>%Ln Zeile</numerusform>
            <numerusform>%Ln Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paused, %Ln new</source>
        <translation>
            <numerusform>angehalten, %Ln neue</numerusform>
            <numerusform>angehalten, %Ln neue</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 rows shown</source>
        <translation>%1 von %2 Zeilen gezeigt</translation>
    </message>
    <message>
        <source>%1 dropped</source>
        <translation>%1 verworfen</translation>
    </message>
    <message>
        <source>Another connection begins here.</source>
        <translation>Ab hier eine andere Verbindung.</translation>
    </message>
</context>
<context>
    <name>codewheel::TrainingAct</name>
    <message>
        <source>Started afresh: everything simulated is as at the start, with factory values and without faults.</source>
        <translation>Neu begonnen: Alles Simulierte ist wie am Anfang, mit Werkseinstellungen und ohne Störungen.</translation>
    </message>
</context>
<context>
    <name>codewheel::TrainingArea</name>
    <message>
        <source>Device to train with</source>
        <translation>Teilnehmer zum Üben</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Start afresh</source>
        <translation>Neu beginnen</translation>
    </message>
</context>
<context>
    <name>codewheel::TrainingPanel</name>
    <message>
        <source>EEPROM writes</source>
        <translation>EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Eingeschaltet</translation>
    </message>
    <message>
        <source>Supply of the encoder. It forgets what was not activated.</source>
        <translation>Versorgung des Gebers. Er vergisst, was nicht aktiviert wurde.</translation>
    </message>
    <message>
        <source>Slow confirmation</source>
        <translation>Langsame Quittung</translation>
    </message>
    <message>
        <source>The encoder takes 50 times as long to confirm a parameter</source>
        <translation>Der Geber braucht 50-mal so lang, um einen Parameter zu quittieren</translation>
    </message>
    <message>
        <source>Battery low</source>
        <translation>Batterie schwach</translation>
    </message>
    <message>
        <source>The encoder tests its battery when it is switched on</source>
        <translation>Der Geber prüft seine Batterie beim Einschalten</translation>
    </message>
    <message>
        <source>Power off and on</source>
        <translation>Aus- und einschalten</translation>
    </message>
    <message>
        <source>Switch the encoder off and on again after 50 ms</source>
        <translation>Den Geber ausschalten und nach 50 ms wieder einschalten</translation>
    </message>
    <message>
        <source>Lose parameters</source>
        <translation>Parameter verlieren</translation>
    </message>
    <message>
        <source>The EEPROM content is destroyed: error 3, until it is parameterized again</source>
        <translation>Der EEPROM-Inhalt wird zerstört: Fehler 3 bis zur nächsten Parametrierung</translation>
    </message>
    <message>
        <source>EEPROM worn out</source>
        <translation>EEPROM verschlissen</translation>
    </message>
    <message>
        <source>Error 13 when run is to store parameters</source>
        <translation>Fehler 13, wenn Run Parameter speichern soll</translation>
    </message>
    <message>
        <source>Code disc faulty</source>
        <translation>Codescheibe defekt</translation>
    </message>
    <message>
        <source>Error 15, by itself</source>
        <translation>Fehler 15, von selbst</translation>
    </message>
    <message>
        <source>The simulated device that is moved, switched and disturbed here</source>
        <translation>Der simulierte Teilnehmer, der hier bewegt, geschaltet und gestört wird</translation>
    </message>
</context>
<context>
    <name>codewheel::TrainingPlanReader</name>
    <message>
        <source>A bus terminal has no encoder.</source>
        <translation>Eine Busklemme hat keinen Geber.</translation>
    </message>
    <message>
        <source>A device number such as &quot;6.1&quot; is expected here.</source>
        <translation>Hier wird eine Teilnehmernummer wie &quot;6.1&quot; erwartet.</translation>
    </message>
    <message>
        <source>A branch needs a bus terminal before it: %1.0.</source>
        <translation>Vor einem Abzweig muss eine Busklemme stehen: %1.0.</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot; in the catalog.</source>
        <translation>Im Katalog gibt es kein Gerät „%1“.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; cannot be simulated.</source>
        <translation>Das Gerät „%1“ lässt sich nicht simulieren.</translation>
    </message>
    <message>
        <source>Only a FRABA K3 has this.</source>
        <translation>Das hat nur ein FRABA K3.</translation>
    </message>
    <message>
        <source>A linear encoder has no shaft.</source>
        <translation>Ein Lineargeber hat keine Welle.</translation>
    </message>
    <message>
        <source>Only a linear encoder has a rod.</source>
        <translation>Nur ein Lineargeber hat einen Stab.</translation>
    </message>
    <message>
        <source>The device has no parameter &quot;%1&quot;.</source>
        <translation>Das Gerät hat keinen Parameter „%1“.</translation>
    </message>
    <message>
        <source>The participants must be in the order of the ring.</source>
        <translation>Die Teilnehmer müssen in der Reihenfolge des Rings stehen.</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferChoice</name>
    <message>
        <source>Cam &amp;programs too</source>
        <translation>Auch Nocken&amp;programme</translation>
    </message>
    <message>
        <source>Write what the project wants</source>
        <translation>Projektwerte schreiben</translation>
    </message>
    <message>
        <source>Write what the project has stored</source>
        <translation>Abgelegte Werte schreiben</translation>
    </message>
    <message>
        <source>Store in the project what encoders have</source>
        <translation>Geberwerte im Projekt ablegen</translation>
    </message>
    <message>
        <source>Give the values of one encoder to others</source>
        <translation>Werte eines Gebers an andere übertragen</translation>
    </message>
    <message>
        <source>What is transferred</source>
        <translation>Was übertragen wird</translation>
    </message>
    <message>
        <source>What is transferred. Nothing is sent by choosing.</source>
        <translation>Was übertragen wird. Das Wählen sendet nichts.</translation>
    </message>
    <message>
        <source>Encoder whose values the others get</source>
        <translation>Geber, dessen Werte die anderen bekommen</translation>
    </message>
    <message>
        <source>The encoder whose values the others get, as far as they are known</source>
        <translation>Der Geber, dessen Werte die anderen bekommen, soweit sie bekannt sind</translation>
    </message>
    <message>
        <source>What the encoder had before this program wrote to it</source>
        <translation>Was der Geber hatte, bevor dieses Programm in ihn schrieb</translation>
    </message>
    <message>
        <source>Cam programs are read in the cam mode of each; leaving one that was changed before costs an EEPROM write.</source>
        <translation>Jedes Nockenprogramm wird in seinem eigenen Nockenbetrieb gelesen; ein zuvor geändertes zu verlassen kostet einen EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>Über&amp;tragen</translation>
    </message>
    <message>
        <source>Restore earlier values</source>
        <translation>Vorige Werte wiederherstellen</translation>
    </message>
    <message>
        <source>Earlier values</source>
        <translation>Vorige Werte</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferLines</name>
    <message>
        <source>not there</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>schon vorhanden</translation>
    </message>
    <message>
        <source>The encoder has it: it is left out.</source>
        <translation>Steht schon im Geber: wird ausgelassen.</translation>
    </message>
    <message>
        <source>Cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>It is read first, and written where it differs.</source>
        <translation>Wird zuerst gelesen und bei Abweichung geschrieben.</translation>
    </message>
    <message>
        <source>It cannot be read: what is known of it is stored.</source>
        <translation>Er lässt sich nicht auslesen: Abgelegt wird, was von ihm bekannt ist.</translation>
    </message>
    <message>
        <source>Values to read: %1. It shows no position meanwhile.</source>
        <translation>Zu lesende Werte: %1. Solange zeigt er keine Position.</translation>
    </message>
    <message>
        <source>Its cam programs are read in the cam mode of each. A program that was changed before is stored when it is left: one EEPROM write.</source>
        <translation>Jedes seiner Nockenprogramme wird in dessen Nockenbetrieb gelesen. Ein zuvor geändertes Programm wird beim Verlassen gespeichert: ein EEPROM-Schreibvorgang.</translation>
    </message>
    <message>
        <source>What will be sent for it</source>
        <translation>Was dafür gesendet wird</translation>
    </message>
    <message>
        <source>Values to read: %1. It goes on showing its position.</source>
        <translation>Zu lesende Werte: %1. Dabei zeigt er weiter seine Position.</translation>
    </message>
    <message>
        <source>The project has none stored.</source>
        <translation>Im Projekt ist keiner abgelegt.</translation>
    </message>
    <message>
        <source>As known on %1: %2</source>
        <comment>date and time, by hand</comment>
        <translation>So bekannt am %1: %2</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>Not up to date: %1</source>
        <comment>a sentence</comment>
        <translation>Nicht aktuell: %1</translation>
    </message>
    <message>
        <source>Computed from the other values, and sent after them</source>
        <translation>Aus den anderen Werten berechnet und nach ihnen gesendet</translation>
    </message>
    <message>
        <source>Not wanted: it goes along as it is known, otherwise as from the factory</source>
        <translation>Nicht gewünscht: geht mit, wie er bekannt ist, sonst wie ab Werk</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferModel</name>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Encoder and parameter</source>
        <translation>Geber, Parameter</translation>
    </message>
    <message>
        <source>In the project</source>
        <translation>Im Projekt</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>EEPROM</source>
        <translation>EEPROM</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet wird</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannt</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferPage</name>
    <message>
        <source>What differs</source>
        <translation>Was abweicht</translation>
    </message>
    <message>
        <source>Choose &amp;all</source>
        <translation>Alle &amp;wählen</translation>
    </message>
    <message>
        <source>Choose &amp;none</source>
        <translation>&amp;Keine wählen</translation>
    </message>
    <message>
        <source>&amp;Stop after a refusal</source>
        <translation>&amp;Nach einer Ablehnung anhalten</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>Chooses every encoder that can be written to</source>
        <translation>Wählt jeden Geber, in den geschrieben werden kann</translation>
    </message>
    <message>
        <source>Shows what differs now</source>
        <translation>Zeigt, was jetzt abweicht</translation>
    </message>
    <message>
        <source>&amp;Read and store</source>
        <translation>&amp;Lesen und ablegen</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>There is nothing to restore.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>There is nothing to transfer: nothing is wanted, stored or known.</source>
        <translation>Es gibt nichts zu übertragen: Nichts ist gewünscht, abgelegt oder bekannt.</translation>
    </message>
    <message>
        <source>Encoders chosen: %1.</source>
        <translation>Gewählte Geber: %1.</translation>
    </message>
    <message>
        <source>Encoders chosen: %1. EEPROM writes: at most %2.</source>
        <translation>Gewählte Geber: %1. EEPROM-Schreibvorgänge: höchstens %2.</translation>
    </message>
    <message>
        <source>Store values of encoders</source>
        <translation>Werte von Gebern ablegen</translation>
    </message>
    <message>
        <source>Values of %1</source>
        <translation>Werte von %1</translation>
    </message>
    <message>
        <source>Sends what is shown above to the chosen encoders, one after the other</source>
        <translation>Sendet das oben Gezeigte an die gewählten Geber, an einen nach dem anderen</translation>
    </message>
    <message>
        <source>What was written. Nothing more is sent.</source>
        <translation>Was geschrieben wurde. Es wird nichts mehr gesendet.</translation>
    </message>
    <message>
        <source>Writes to encoders. Nothing is sent before Write.</source>
        <translation>Schreibt in Geber. Vor „Schreiben“ wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Chooses no encoder</source>
        <translation>Wählt keinen</translation>
    </message>
    <message>
        <source>Start no other encoder after one has refused</source>
        <translation>Keinen weiteren Geber beginnen, wenn einer abgelehnt hat</translation>
    </message>
    <message>
        <source>Reads the chosen encoders, and stores in the project what they have. Those on a ring show no position meanwhile</source>
        <translation>Liest die gewählten Geber aus und legt ihre Werte im Projekt ab. Die eines Rings zeigen solange keine Position</translation>
    </message>
    <message>
        <source>Stores in the project what encoders have. Nothing is sent before Read and store.</source>
        <translation>Legt im Projekt ab, was Geber haben. Vor Lesen und Ablegen wird nichts gesendet.</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferPages</name>
    <message>
        <source>No encoder is chosen.</source>
        <translation>Kein Geber gewählt.</translation>
    </message>
    <message>
        <source>Restore &amp;values of %1…</source>
        <translation>&amp;Werte von %1 wiederherstellen…</translation>
    </message>
    <message>
        <source>Shows what the encoder had before this program wrote to it, and writes it again</source>
        <translation>Zeigt, was der Geber hatte, bevor dieses Programm in ihn schrieb, und schreibt es wieder</translation>
    </message>
    <message>
        <source>Not connected: nothing can be sent.</source>
        <translation>Nicht verbunden: Es lässt sich nichts senden.</translation>
    </message>
    <message>
        <source>Gives the new encoder at this place the values and the position of the previous one</source>
        <translation>Gibt einem neuen Geber an diesem Platz die Werte und die Position des vorigen</translation>
    </message>
    <message>
        <source>Restore earlier &amp;values…</source>
        <translation>Vorige &amp;Werte wiederherstellen…</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferReport</name>
    <message>
        <source>Values written to encoders</source>
        <translation>In Geber geschriebene Werte</translation>
    </message>
    <message>
        <source>Values of one encoder given to others</source>
        <translation>Werte eines Gebers an andere übertragen</translation>
    </message>
    <message>
        <source>Encoder replaced</source>
        <translation>Geber ersetzt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>Begonnen</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>EEPROM writes</source>
        <translation>EEPROM-Schreibvorgänge</translation>
    </message>
    <message>
        <source>Position to be set</source>
        <translation>Zu setzende Position</translation>
    </message>
    <message>
        <source>Position before</source>
        <translation>Position vorher</translation>
    </message>
    <message>
        <source>Position after</source>
        <translation>Position nachher</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Gewünscht</translation>
    </message>
    <message>
        <source>What became of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>Cam program %1</source>
        <translation>Nockenprogramm %1</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>%1 of %2 have all of it</source>
        <translation>%1 von %2 haben alles</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>Schon vorhanden</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Earlier values restored</source>
        <translation>Vorige Werte wiederhergestellt</translation>
    </message>
    <message>
        <source>State afterwards</source>
        <translation>Zustand danach</translation>
    </message>
    <message>
        <source>Replacement of an encoder, not completed</source>
        <translation>Ersatz eines Gebers, nicht abgeschlossen</translation>
    </message>
    <message>
        <source>Setting the position</source>
        <translation>Setzen der Position</translation>
    </message>
    <message>
        <source>Stored, in force before</source>
        <translation>Gespeichert, galten schon vorher</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferTable</name>
    <message>
        <source>Space chooses an encoder</source>
        <translation>Die Leertaste wählt einen Geber</translation>
    </message>
</context>
<context>
    <name>codewheel::TransferWords</name>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Already there</source>
        <translation>War schon vorhanden</translation>
    </message>
    <message>
        <source>Not done</source>
        <translation>Nicht ausgeführt</translation>
    </message>
    <message>
        <source>Written, and read back</source>
        <translation>Geschrieben und zurückgelesen</translation>
    </message>
    <message>
        <source>Written, confirmed by the handshake</source>
        <translation>Geschrieben, im Handshake quittiert</translation>
    </message>
    <message>
        <source>in operation</source>
        <translation>in Betrieb</translation>
    </message>
    <message>
        <source>in parameterization: it gives no position until run is sent</source>
        <translation>in der Parametrierung: Er liefert keine Position, bis Run gesendet wird</translation>
    </message>
    <message>
        <source>in the error state: it gives no valid position</source>
        <translation>im Fehlerzustand: Er liefert keine gültige Position</translation>
    </message>
    <message>
        <source>still showing a read-out value</source>
        <translation>noch mit einem Auslesewert</translation>
    </message>
    <message>
        <source>in service mode: it gives no position until the service bit is 0</source>
        <translation>im Dienstbetrieb: Er liefert keine Position, bis das Dienst-Bit 0 ist</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Cam programs are read, written where they differ, and stored when they are left.</source>
        <translation>Nockenprogramme werden gelesen, bei Abweichung geschrieben und beim Verlassen gespeichert.</translation>
    </message>
    <message>
        <source>A preset acts once: it is programmed again where it is used up.</source>
        <translation>Ein Preset wirkt einmal: Ist er verbraucht, wird er neu programmiert.</translation>
    </message>
    <message>
        <source>Values and cam programs to write: %1. EEPROM writes: at most %2.</source>
        <translation>Zu schreibende Werte und Nockenprogramme: %1. EEPROM-Schreibvorgänge: höchstens %2.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Erledigt.</translation>
    </message>
    <message>
        <source>It has no &quot;%1&quot;: the value %2 is not written.</source>
        <translation>Er hat „%1“ nicht: Der Wert %2 wird nicht geschrieben.</translation>
    </message>
    <message>
        <source>It has no cams: the cam programs are not written.</source>
        <translation>Er hat keine Nocken: Die Nockenprogramme werden nicht geschrieben.</translation>
    </message>
    <message>
        <source>silent: it does not answer</source>
        <translation>stumm: antwortet nicht</translation>
    </message>
    <message>
        <source>Sent: it is not known whether the encoder has it</source>
        <translation>Gesendet: ob der Geber es hat, ist nicht bekannt</translation>
    </message>
    <message>
        <source>Earlier value restored</source>
        <translation>Voriger Wert wiederhergestellt</translation>
    </message>
    <message>
        <source>At the end, the position is set to %1.</source>
        <translation>Am Ende wird die Position auf %1 gesetzt.</translation>
    </message>
    <message>
        <source>Nothing is wanted for it.</source>
        <translation>Von ihm wird nichts gewünscht.</translation>
    </message>
    <message>
        <source>It has everything already: nothing is sent.</source>
        <translation>Alles ist schon vorhanden: Es wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Not started.</source>
        <translation>Nicht begonnen.</translation>
    </message>
    <message>
        <source>It had everything already: nothing was sent.</source>
        <translation>Alles war schon vorhanden: Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>A %1 was planned; the new one is a %2.</source>
        <translation>Geplant war ein %1; der neue ist ein %2.</translation>
    </message>
    <message>
        <source>It has %2 physical steps per turn, the previous one had %1.</source>
        <translation>Er hat %2 physikalische Schritte je Umdrehung, der vorige hatte %1.</translation>
    </message>
    <message>
        <source>It has %2 turns, the previous one had %1.</source>
        <translation>Er hat %2 Umdrehungen, der vorige hatte %1.</translation>
    </message>
    <message>
        <source>Accepted, but not valid until run is sent</source>
        <translation>Übernommen, aber erst nach Run gültig</translation>
    </message>
    <message>
        <source>Acknowledged, not active</source>
        <translation>Quittiert, nicht wirksam</translation>
    </message>
    <message>
        <source>%1; OUT may still hold %2</source>
        <comment>a state, words</comment>
        <translation>%1; in OUT kann noch %2 stehen</translation>
    </message>
    <message>
        <source>Set</source>
        <comment>the position</comment>
        <translation>Gesetzt</translation>
    </message>
    <message>
        <source>%1; in which mode is not known</source>
        <comment>a state</comment>
        <translation>%1; in welcher Betriebsart, ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <comment>a state, a mode</comment>
        <translation>%1, im %2</translation>
    </message>
    <message>
        <source>%1; left in %2: the controller gets no position</source>
        <comment>a state, a mode</comment>
        <translation>%1; blieb im %2: Die Steuerung bekommt keine Position</translation>
    </message>
    <message>
        <source>In force before, and stored now</source>
        <translation>Galt schon vorher, jetzt gespeichert</translation>
    </message>
    <message>
        <source>waiting for its parameters or to be started: it gives no position</source>
        <translation>wartet auf seine Parameter oder den Start: Er liefert keine Position</translation>
    </message>
</context>
<context>
    <name>codewheel::TreeFilter</name>
    <message>
        <source>Filter devices</source>
        <translation>Geräte filtern</translation>
    </message>
    <message>
        <source>To the devices that are left</source>
        <translation>Zu den Geräten, die übrig sind</translation>
    </message>
    <message>
        <source>Shows all devices</source>
        <translation>Zeigt alle Geräte</translation>
    </message>
    <message>
        <source>Shows the devices whose station, place, make or state contains these words; Esc shows all</source>
        <translation>Zeigt die Geräte, in deren Station, Platz, Hersteller oder Zustand diese Wörter stehen; Esc zeigt alle</translation>
    </message>
</context>
<context>
    <name>codewheel::TrendChart</name>
    <message>
        <source>Scrolls to earlier or later times</source>
        <translation>Rollt zu früheren oder späteren Zeiten</translation>
    </message>
    <message>
        <source>Zooms in or out</source>
        <translation>Vergrößert oder verkleinert</translation>
    </message>
    <message>
        <source>Chooses the cursor that keys move</source>
        <translation>Wählt den Cursor, den Tasten schieben</translation>
    </message>
    <message>
        <source>Moves the cursor by a pixel</source>
        <translation>Schiebt den Cursor um ein Pixel</translation>
    </message>
    <message>
        <source>Moves the cursor by ten pixels</source>
        <translation>Schiebt den Cursor um zehn Pixel</translation>
    </message>
    <message>
        <source>Ends a drag without an effect</source>
        <translation>Beendet ein Ziehen ohne Wirkung</translation>
    </message>
</context>
<context>
    <name>codewheel::TrendFiles</name>
    <message>
        <source>It does not belong to a trend. Give the trend another name.</source>
        <translation>Diese Datei gehört zu keinem Trend. Bitte dem Trend einen anderen Namen geben.</translation>
    </message>
</context>
<context>
    <name>codewheel::TrendPage</name>
    <message>
        <source>Nothing is sent here.</source>
        <translation>Hier wird nichts gesendet.</translation>
    </message>
    <message numerus="yes">
        <source>No more than %n curves can be shown. Remove one first.</source>
        <translation>
            <numerusform>Mehr als %n Kurve kann nicht gezeigt werden. Entfernen Sie zuerst eine.</numerusform>
            <numerusform>Mehr als %n Kurven können nicht gezeigt werden. Entfernen Sie zuerst eine.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click into the curves for cursor A, with Shift for cursor B.</source>
        <translation>Ein Klick in die Kurven setzt Cursor A, mit Umschalt Cursor B.</translation>
    </message>
    <message>
        <source>Kept: %1, %2 of %3 MB</source>
        <comment>a duration, megabytes</comment>
        <translation>Aufbewahrt: %1, %2 von %3 MB</translation>
    </message>
    <message>
        <source>enough for %1 at the present rate</source>
        <translation>reicht beim jetzigen Anfall für %1</translation>
    </message>
    <message numerus="yes">
        <source>%n cycles came too fast and are missing</source>
        <translation>
            <numerusform>%n Zyklus kam zu schnell und fehlt</numerusform>
            <numerusform>%n Zyklen kamen zu schnell und fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no later mark.</source>
        <translation>Es gibt keine spätere Marke.</translation>
    </message>
    <message>
        <source>There is no earlier mark.</source>
        <translation>Es gibt keine frühere Marke.</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>trend.png</source>
        <translation>trend.png</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Export the trend</source>
        <translation>Trend exportieren</translation>
    </message>
    <message>
        <source>trend.csv</source>
        <translation>trend.csv</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Writing %1: %2 %</source>
        <translation>%1 wird geschrieben: %2 %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>%1 is written: %n rows; the file beside it says what they are.</source>
        <translation>
            <numerusform>%1 ist geschrieben: %n Zeile; die Datei daneben sagt, was sie ist.</numerusform>
            <numerusform>%1 ist geschrieben: %n Zeilen; die Datei daneben sagt, was sie sind.</numerusform>
        </translation>
    </message>
    <message>
        <source>The export is cancelled; nothing was written.</source>
        <translation>Der Export ist abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>No curve is shown</source>
        <translation>Keine Kurve ist gezeigt</translation>
    </message>
    <message>
        <source>Drag an encoder from the bus structure here, or choose a curve with Add. What encoders show is kept whether it is shown or not.</source>
        <translation>Ziehen Sie einen Geber aus dem Busaufbau hierher, oder wählen Sie mit Hinzufügen eine Kurve. Was Geber zeigen, wird aufbewahrt, ob als Kurve gezeigt oder nicht.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Shows another curve (Ctrl+Ins)</source>
        <translation>Zeigt eine weitere Kurve (Strg+Einfg)</translation>
    </message>
    <message>
        <source>Add a curve</source>
        <translation>Eine Kurve hinzufügen</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the newest values in sight</source>
        <translation>Hält die neuesten Werte im Blick</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Holds the picture; all that comes is kept and shown afterwards</source>
        <translation>Hält das Bild an; alles, was kommt, wird aufbewahrt und danach gezeigt</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Shows all the time there is, with axes that fit</source>
        <translation>Zeigt die ganze Zeit, mit passenden Achsen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Marks the moment at the cursor with a text</source>
        <translation>Markiert den Zeitpunkt am Cursor mit einem Text</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Saves what is seen as a PNG or SVG file</source>
        <translation>Speichert, was zu sehen ist, als PNG- oder SVG-Datei</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Saves the curves that are shown as a table (Ctrl+E)</source>
        <translation>Speichert die gezeigten Kurven als Tabelle (Strg+E)</translation>
    </message>
    <message>
        <source>What is &amp;seen…</source>
        <translation>Was zu &amp;sehen ist…</translation>
    </message>
    <message>
        <source>What is &amp;between the cursors…</source>
        <translation>Was &amp;zwischen den Cursorn ist…</translation>
    </message>
    <message>
        <source>&amp;All that is kept…</source>
        <translation>&amp;Alles, was aufbewahrt ist…</translation>
    </message>
    <message>
        <source>For s&amp;preadsheets of this country</source>
        <translation>Für Tabellen&amp;programme dieses Landes</translation>
    </message>
    <message>
        <source>With its decimal sign, and with dates and times of day; otherwise with commas, points and seconds, as programs take it</source>
        <translation>Mit dessen Dezimalzeichen, mit Datum und Uhrzeit; sonst mit Kommas, Punkten und Sekunden, wie Programme es nehmen</translation>
    </message>
    <message>
        <source>Cursor to the next mark</source>
        <translation>Cursor zur nächsten Marke</translation>
    </message>
    <message>
        <source>Cursor to the mark before</source>
        <translation>Cursor zur Marke davor</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>Cursor entfernen</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>The curves, and what they are at the cursors</source>
        <translation>Die Kurven, und was sie an den Cursorn sind</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translation>Spalten der Tabelle</translation>
    </message>
    <message>
        <source>Values at the cursors, or statistics between them</source>
        <translation>Werte an den Cursorn, oder Statistik dazwischen</translation>
    </message>
    <message>
        <source>Remove curve</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Move the curve up</source>
        <translation>Kurve nach oben schieben</translation>
    </message>
    <message>
        <source>Move the curve down</source>
        <translation>Kurve nach unten schieben</translation>
    </message>
    <message>
        <source>There is no other curve to begin with. Add one first.</source>
        <translation>Es gibt keine andere Kurve, mit der sie beginnen könnte. Zuerst eine hinzufügen.</translation>
    </message>
    <message>
        <source>There is no room for more curves. Remove some first.</source>
        <translation>Für weitere Kurven ist kein Platz. Erst einige entfernen.</translation>
    </message>
    <message>
        <source>Add a curve of one of the recordings first.</source>
        <translation>Erst eine Kurve einer der Aufzeichnungen hinzufügen.</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Lays the open recordings on each other: all begin together, with the same curves of each</source>
        <translation>Legt die offenen Aufzeichnungen übereinander: Alle beginnen gemeinsam, mit den gleichen Kurven von jeder</translation>
    </message>
    <message>
        <source>With a column of &amp;dates</source>
        <translation>Mit &amp;Datumsspalte</translation>
    </message>
    <message>
        <source>Beside the seconds: date and time of day, with the offset from UTC</source>
        <translation>Neben den Sekunden: Datum und Uhrzeit samt Abstand zu UTC</translation>
    </message>
</context>
<context>
    <name>codewheel::TrendValuesModel</name>
    <message>
        <source>The encoder, what is shown of it, and its unit</source>
        <translation>Der Geber, was von ihm gezeigt wird, und die Einheit</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>The newest value; a dash where none is shown</source>
        <translation>Der neueste Wert; ein Strich, wo keiner gezeigt wird</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>The value at cursor A</source>
        <translation>Der Wert an Cursor A</translation>
    </message>
    <message>
        <source>The value at cursor B</source>
        <translation>Der Wert an Cursor B</translation>
    </message>
    <message>
        <source>From cursor A to cursor B</source>
        <translation>Von Cursor A bis Cursor B</translation>
    </message>
    <message>
        <source>From cursor A to cursor B, in degrees of the shaft</source>
        <translation>Von Cursor A bis Cursor B, in Grad der Welle</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>The mean speed from cursor A to cursor B</source>
        <translation>Die mittlere Geschwindigkeit von Cursor A bis Cursor B</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>The least value between the cursors</source>
        <translation>Der kleinste Wert zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>The greatest value between the cursors</source>
        <translation>Der größte Wert zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>The mean over time between the cursors</source>
        <translation>Der Mittelwert über die Zeit zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>The standard deviation between the cursors</source>
        <translation>Die Standardabweichung zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Std.abw.</translation>
    </message>
</context>
<context>
    <name>codewheel::TrendView</name>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Wheel: zoom, with Shift scroll. Drag a box: zoom into it, with Ctrl scroll. Click: cursor A, with Shift cursor B.</source>
        <translation>Rad: vergrößern, mit Umschalt rollen. Rahmen ziehen: hinein vergrößern, mit Strg verschieben. Klick: Cursor A, mit Umschalt Cursor B.</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>Scrolls through all the time that is kept</source>
        <translation>Rollt durch die ganze aufbewahrte Zeit</translation>
    </message>
</context>
<context>
    <name>codewheel::TriggerFields</name>
    <message>
        <source>Begins</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>At once, or once something happens</source>
        <translation>Sofort oder sobald etwas geschieht</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Where it has to happen</source>
        <translation>Wo es geschehen muss</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
    <message>
        <source>The word the bit is in, or the cams</source>
        <translation>Das Wort, in dem das Bit ist, oder die Nocken</translation>
    </message>
    <message>
        <source>The number of the bit, or of the cam</source>
        <translation>Die Nummer des Bits oder der Nocke</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>What the bit becomes</source>
        <translation>Was das Bit wird</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>What has a threshold</source>
        <translation>Wovon die Schwelle ist</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>From which side the threshold is passed</source>
        <translation>Von welcher Seite die Schwelle überschritten wird</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>What is beyond it already has to come back first</source>
        <translation>Was schon jenseits davon ist, muss erst zurückkommen</translation>
    </message>
    <message>
        <source>Unit of the threshold</source>
        <translation>Einheit der Schwelle</translation>
    </message>
    <message>
        <source>Units are offered as in the trend</source>
        <translation>Zur Wahl stehen die Einheiten des Trends</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>when a bit or a cam changes</source>
        <translation>wenn ein Bit oder eine Nocke wechselt</translation>
    </message>
    <message>
        <source>when a value passes a threshold</source>
        <translation>wenn ein Wert eine Schwelle überschreitet</translation>
    </message>
    <message>
        <source>at a fault</source>
        <translation>bei einer Störung</translation>
    </message>
    <message>
        <source>at a message of attention or a fault</source>
        <translation>bei Achtung oder einer Störung</translation>
    </message>
    <message>
        <source>at any message</source>
        <translation>bei jeder Meldung</translation>
    </message>
    <message>
        <source>becomes 1</source>
        <translation>wird 1</translation>
    </message>
    <message>
        <source>becomes 0</source>
        <translation>wird 0</translation>
    </message>
    <message>
        <source>rises to</source>
        <translation>steigt auf</translation>
    </message>
    <message>
        <source>falls below</source>
        <translation>fällt unter</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>cam</source>
        <translation>Nocke</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
</context>
<context>
    <name>codewheel::UnseenFaults</name>
    <message>
        <source>Fault: %1</source>
        <comment>place</comment>
        <translation>Störung: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n faults, the last: %1</source>
        <comment>place</comment>
        <translation>
            <numerusform>%n Störung, zuletzt: %1</numerusform>
            <numerusform>%n Störungen, zuletzt: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>codewheel::UserDevices</name>
    <message>
        <source>There is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>The file cannot be read: %1.</source>
        <translation>Die Datei lässt sich nicht lesen: %1.</translation>
    </message>
    <message>
        <source>The file is larger than 1 MiB: it is not a device description.</source>
        <translation>Die Datei ist größer als 1 MiB: Sie ist keine Gerätebeschreibung.</translation>
    </message>
</context>
<context>
    <name>codewheel::ValueBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leaves everything unchanged (Esc)</source>
        <translation>Lässt alles unverändert (Esc)</translation>
    </message>
</context>
<context>
    <name>codewheel::ValueInput</name>
    <message>
        <source>&quot;%1&quot; can be hexadecimal or decimal. Write %2 or %3.</source>
        <translation>„%1“ kann hexadezimal oder dezimal gemeint sein. %2 oder %3 schreiben.</translation>
    </message>
</context>
<context>
    <name>codewheel::ValuesPage</name>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>&amp;Set the position to the preset now</source>
        <translation>Position jetzt auf den Preset &amp;setzen</translation>
    </message>
    <message>
        <source>After run, 40000000 makes the place where the shaft stands the preset value.</source>
        <translation>Nach Run setzt 40000000 die Position dort, wo die Welle steht, auf den Presetwert.</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position to set now</source>
        <translation>Jetzt zu setzende Position</translation>
    </message>
    <message>
        <source>&amp;Set the position now to</source>
        <translation>Die Position jetzt &amp;setzen auf</translation>
    </message>
    <message>
        <source>After the values, service 6 makes the place where the magnet stands this position.</source>
        <translation>Nach den Werten setzt Dienst 6 die Position dort, wo der Magnet steht, auf diesen Wert.</translation>
    </message>
    <message>
        <source>After the values, GP makes the place where the shaft stands this position.</source>
        <translation>Nach den Werten setzt GP die Position dort, wo die Welle steht, auf diesen Wert.</translation>
    </message>
</context>
<context>
    <name>codewheel::WantedValues</name>
    <message>
        <source>%1 wanted for %2</source>
        <translation>%1 gewünscht für %2</translation>
    </message>
    <message>
        <source>Nothing wanted for %1</source>
        <translation>Nichts gewünscht für %1</translation>
    </message>
</context>
<context>
    <name>codewheel::WhatRunMakesValid</name>
    <message>
        <source>IN (%1) confirms %2 with the data %3.</source>
        <comment>a name, a number</comment>
        <translation>IN (%1) bestätigt %2 mit den Daten %3.</translation>
    </message>
    <message>
        <source>Run makes valid what was written to it, by whomever.</source>
        <translation>Run macht gültig, was ihm geschrieben wurde, gleich von wem.</translation>
    </message>
    <message>
        <source>Run makes valid what it has taken, from here: %1.</source>
        <translation>Run macht gültig, was er von hier übernommen hat: %1.</translation>
    </message>
    <message>
        <source>IN (%1) says: %2.</source>
        <comment>what it may confirm</comment>
        <translation>IN (%1) sagt: %2.</translation>
    </message>
    <message>
        <source>The encoder then switches its cams by these values, and what the controller drives by them can move.</source>
        <translation>Danach schaltet der Geber seine Nocken nach diesen Werten, und was die Steuerung danach antreibt, kann sich bewegen.</translation>
    </message>
    <message>
        <source>Its mode is not known: the encoder then gives its position by these values, or switches its cams by them. The position can jump, cams can switch, and what the controller drives by them can move.</source>
        <translation>Seine Betriebsart ist nicht bekannt: Danach gibt der Geber seine Position nach diesen Werten aus oder schaltet seine Nocken danach. Die Position kann springen, Nocken können schalten, und was die Steuerung danach antreibt, kann sich bewegen.</translation>
    </message>
    <message>
        <source>The encoder then gives its position by these values: it can jump, and what the controller drives by it can move.</source>
        <translation>Danach gibt der Geber seine Position nach diesen Werten aus: Sie kann springen, und was die Steuerung danach antreibt, kann sich bewegen.</translation>
    </message>
    <message>
        <source>Which position it will read is not known.</source>
        <translation>Welche Position er anzeigen wird, ist nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>codewheel::WhyPage</name>
    <message>
        <source>Everything is as expected</source>
        <translation>Alles ist wie erwartet</translation>
    </message>
    <message>
        <source>Expected and came, step by step</source>
        <translation>Erwartet und tatsächlich, Schritt für Schritt</translation>
    </message>
    <message>
        <source>What is expected on the way of the data, and what came.</source>
        <translation>Was auf dem Weg der Daten erwartet wird, und was tatsächlich ist.</translation>
    </message>
    <message>
        <source>Nothing is chosen</source>
        <translation>Nichts ist gewählt</translation>
    </message>
    <message>
        <source>Only looks at what is known. Nothing is sent here.</source>
        <translation>Zeigt nur Bekanntes. Hier wird nichts gesendet.</translation>
    </message>
    <message>
        <source>What differs first: %1</source>
        <translation>Erste Abweichung: %1</translation>
    </message>
    <message>
        <source>Why is there no data?</source>
        <translation>Warum kommen keine Daten?</translation>
    </message>
    <message>
        <source>%1. Position: %2</source>
        <comment>a sentence without its full stop</comment>
        <translation>%1. Position: %2</translation>
    </message>
    <message>
        <source>Data comes</source>
        <translation>Daten kommen</translation>
    </message>
    <message>
        <source>Choose a device or a bus in the bus structure. If it is empty, connect a bus first, or search with &quot;Who is there?&quot;.</source>
        <translation>Wählen Sie ein Gerät oder einen Bus im Busaufbau. Ist er leer, verbinden Sie zuerst einen Bus, oder suchen Sie mit „Wer ist da?“.</translation>
    </message>
</context>
<context>
    <name>codewheel::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Saves the handshake trace as a CSV file</source>
        <translation>Speichert das Handshake-Protokoll als CSV-Datei</translation>
    </message>
    <message>
        <source>Saves the messages as a CSV file</source>
        <translation>Speichert die Meldungen als CSV-Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Bus</source>
        <translation>&amp;Bus</translation>
    </message>
    <message>
        <source>&amp;Watch</source>
        <translation>Be&amp;obachten</translation>
    </message>
    <message>
        <source>&amp;Operate</source>
        <translation>Be&amp;dienen</translation>
    </message>
    <message>
        <source>Operate: writing is allowed</source>
        <translation>Bedienen: Schreiben ist erlaubt</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>Parameter &amp;wizard</source>
        <translation>&amp;Parametrierassistent</translation>
    </message>
    <message>
        <source>Sets up the chosen encoder step by step</source>
        <translation>Richtet den gewählten Geber Schritt für Schritt ein</translation>
    </message>
    <message>
        <source>Set OUT to &amp;00000000</source>
        <translation>OUT auf &amp;00000000 setzen</translation>
    </message>
    <message>
        <source>Sends 00000000 to the chosen device: normal running</source>
        <translation>Sendet 00000000 an das gewählte Gerät: Normalbetrieb</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Monitors</source>
        <translation>&amp;Monitore</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Be&amp;reiche</translation>
    </message>
    <message>
        <source>&amp;Default layout</source>
        <translation>&amp;Standardanordnung</translation>
    </message>
    <message>
        <source>Puts all panels back in their places</source>
        <translation>Bringt alle Bereiche an ihren Platz zurück</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Darstellung</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>Wie &amp;System</translation>
    </message>
    <message>
        <source>As light or dark as the desktop</source>
        <translation>So hell oder dunkel wie der Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Dunkel auf Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Hell auf Dunkel</translation>
    </message>
    <message>
        <source>Large &amp;controls</source>
        <translation>&amp;Große Bedienelemente</translation>
    </message>
    <message>
        <source>Larger bits and buttons, for gloves</source>
        <translation>Größere Bits und Schaltflächen, zur Bedienung mit Handschuhen</translation>
    </message>
    <message>
        <source>Less m&amp;otion</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Nothing on the screen is animated</source>
        <translation>Auf dem Bildschirm wird nichts animiert</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>S&amp;ystem</source>
        <translation>Wie S&amp;ystem</translation>
    </message>
    <message>
        <source>The language of the desktop</source>
        <translation>Die Sprache des Desktops</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Lists the keys of the window</source>
        <translation>Listet die Tasten des Fensters auf</translation>
    </message>
    <message>
        <source>&amp;About Codewheel</source>
        <translation>&amp;Über Codewheel</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>&amp;Cams</source>
        <translation>&amp;Nocken</translation>
    </message>
    <message>
        <source>Edits, reads and writes the cam programs of the chosen encoder</source>
        <translation>Bearbeitet, liest und schreibt die Nockenprogramme des gewählten Gebers</translation>
    </message>
    <message>
        <source>No encoder is chosen.</source>
        <translation>Kein Geber gewählt.</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Starts an empty project</source>
        <translation>Beginnt ein leeres Projekt</translation>
    </message>
    <message>
        <source>Opens a project</source>
        <translation>Öffnet ein Projekt</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>&amp;Zuletzt benutzt</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Saves the project</source>
        <translation>Speichert das Projekt</translation>
    </message>
    <message>
        <source>Saves the project in another file</source>
        <translation>Speichert das Projekt in einer anderen Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>B&amp;earbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Bus structure</source>
        <translation>&amp;Busaufbau</translation>
    </message>
    <message>
        <source>Edits the planned bus</source>
        <translation>Bearbeitet den geplanten Bus</translation>
    </message>
    <message>
        <source>T&amp;ransfer</source>
        <translation>Ü&amp;bertragung</translation>
    </message>
    <message>
        <source>Values of several encoders: written from the project, stored in it, given from one to others</source>
        <translation>Werte mehrerer Geber: aus dem Projekt schreiben, darin ablegen oder von einem an andere übertragen</translation>
    </message>
    <message>
        <source>&amp;Replace encoder</source>
        <translation>Geber &amp;ersetzen</translation>
    </message>
    <message>
        <source>Not connected: nothing can be sent.</source>
        <translation>Nicht verbunden: Es lässt sich nichts senden.</translation>
    </message>
    <message>
        <source>Edits the cam programs planned for the chosen encoder</source>
        <translation>Bearbeitet die für den gewählten Geber geplanten Nockenprogramme</translation>
    </message>
    <message>
        <source>Title, note and link of the project</source>
        <translation>Titel, Notiz und Verbindung des Projekts</translation>
    </message>
    <message>
        <source>&amp;ALARM STOP</source>
        <translation>&amp;ALARM-STOPP</translation>
    </message>
    <message>
        <source>&amp;ALARM STOP %1</source>
        <comment>name of a bus</comment>
        <translation>&amp;ALARM-STOPP %1</translation>
    </message>
    <message numerus="yes">
        <source>&amp;ALARM STOP %n buses</source>
        <translation>
            <numerusform>&amp;ALARM-STOPP %n Bus</numerusform>
            <numerusform>&amp;ALARM-STOPP %n Busse</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Compare with the bus</source>
        <translation>Mit dem Bus &amp;vergleichen</translation>
    </message>
    <message>
        <source>Shows what is configured for the chosen bus beside what is connected</source>
        <translation>Stellt den projektierten Aufbau des gewählten Busses dem angeschlossenen gegenüber</translation>
    </message>
    <message>
        <source>No connected device with an OUT word is chosen.</source>
        <translation>Kein verbundenes Gerät mit einem OUT-Wort ist gewählt.</translation>
    </message>
    <message>
        <source>No connected encoder with a handshake trace is chosen.</source>
        <translation>Kein verbundener Geber mit Handshake-Protokoll ist gewählt.</translation>
    </message>
    <message>
        <source>Starts the chosen bus: data is exchanged from then on</source>
        <translation>Startet den gewählten Bus: Von da an werden Daten ausgetauscht</translation>
    </message>
    <message>
        <source>Stops the chosen bus: no more data is exchanged</source>
        <translation>Hält den gewählten Bus an: Es werden keine Daten mehr ausgetauscht</translation>
    </message>
    <message>
        <source>No bus is connected.</source>
        <translation>Kein Bus ist verbunden.</translation>
    </message>
    <message>
        <source>At once: %1</source>
        <translation>Sofort: %1</translation>
    </message>
    <message>
        <source>M&amp;onitor</source>
        <translation>M&amp;onitor</translation>
    </message>
    <message>
        <source>Shows the words of the chosen device</source>
        <translation>Zeigt die Worte des gewählten Geräts</translation>
    </message>
    <message>
        <source>&amp;Pin monitor</source>
        <translation>Monitor an&amp;heften</translation>
    </message>
    <message>
        <source>Watch: nothing is written</source>
        <translation>Beobachten: Nichts wird geschrieben</translation>
    </message>
    <message>
        <source>Close pag&amp;e</source>
        <translation>S&amp;eite schließen</translation>
    </message>
    <message>
        <source>Closes the page that is open, and shows the monitors</source>
        <translation>Schließt die offene Seite und zeigt die Monitore</translation>
    </message>
    <message>
        <source>Wizard</source>
        <comment>on a button</comment>
        <translation>Assistent</translation>
    </message>
    <message>
        <source>Structure</source>
        <comment>on a button</comment>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Compare</source>
        <comment>on a button</comment>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Transfer</source>
        <comment>on a button</comment>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>Replace</source>
        <comment>on a button</comment>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>&amp;Help on this</source>
        <translation>&amp;Hilfe hierzu</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Hand&amp;buch</translation>
    </message>
    <message>
        <source>Opens the manual at its first page</source>
        <translation>Öffnet das Handbuch auf der ersten Seite</translation>
    </message>
    <message>
        <source>Saves what is needed to look into a problem as one file, after it was shown; sends nothing</source>
        <translation>Speichert in einer Datei, was zur Klärung eines Problems nötig ist, nachdem es gezeigt wurde; sendet nichts</translation>
    </message>
    <message>
        <source>Prints the table or the picture that has the focus, or else the commissioning report, after a preview</source>
        <translation>Druckt die Tabelle oder das Bild mit dem Fokus, sonst den Inbetriebnahmebericht, nach einer Vorschau</translation>
    </message>
    <message>
        <source>Pin &amp;dial</source>
        <translation>An&amp;zeige anheften</translation>
    </message>
    <message>
        <source>Keeps the dial of the chosen encoder when another one is chosen</source>
        <translation>Behält die Anzeige des gewählten Gebers, wenn ein anderer gewählt wird</translation>
    </message>
    <message>
        <source>Export handshake &amp;trace…</source>
        <translation>Handshake-&amp;Protokoll exportieren…</translation>
    </message>
    <message>
        <source>Export &amp;messages…</source>
        <translation>&amp;Meldungen exportieren…</translation>
    </message>
    <message>
        <source>Quits the program</source>
        <translation>Beendet das Programm</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Undoes the last change to the project</source>
        <translation>Nimmt die letzte Änderung des Projekts zurück</translation>
    </message>
    <message>
        <source>Redoes what was undone</source>
        <translation>Stellt die zurückgenommene Änderung wieder her</translation>
    </message>
    <message>
        <source>&amp;Commissioning report…</source>
        <translation>&amp;Inbetriebnahmebericht…</translation>
    </message>
    <message>
        <source>Restore earlier &amp;values…</source>
        <translation>Vorige &amp;Werte wiederherstellen…</translation>
    </message>
    <message>
        <source>&amp;Project…</source>
        <translation>Pro&amp;jekt…</translation>
    </message>
    <message>
        <source>Keeps the monitor of the chosen device open when another one is chosen</source>
        <translation>Behält den Monitor des gewählten Geräts, wenn ein anderes gewählt wird</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Language, appearance, numbers, EEPROM warnings, and where files are kept</source>
        <translation>Sprache, Aussehen, Zahlen, EEPROM-Warnungen und wo Dateien liegen</translation>
    </message>
    <message>
        <source>Shows the monitors; you can return to an open page</source>
        <translation>Zeigt die Monitore; auf einer offenen Seite kann danach weitergearbeitet werden</translation>
    </message>
    <message>
        <source>Opens the manual at the section about what has the focus</source>
        <translation>Öffnet das Handbuch dort, wo es vom Element mit dem Fokus handelt</translation>
    </message>
    <message>
        <source>&amp;Collect for support…</source>
        <translation>Für den &amp;Support sammeln…</translation>
    </message>
    <message>
        <source>Pr&amp;int…</source>
        <translation>D&amp;rucken…</translation>
    </message>
    <message>
        <source>&amp;Fold bottom panels</source>
        <translation>Bereiche unten ein&amp;klappen</translation>
    </message>
    <message>
        <source>Folds the panels at the bottom to their tabs: monitors get their height</source>
        <translation>Klappt die Bereiche unten zu ihren Reitern ein: Die Monitore bekommen ihre Höhe</translation>
    </message>
    <message>
        <source>Show in &amp;trend</source>
        <translation>Im &amp;Trend zeigen</translation>
    </message>
    <message>
        <source>Adds the position of the chosen encoder to the trend, and shows that</source>
        <translation>Fügt die Position des gewählten Gebers dem Trend hinzu und zeigt ihn</translation>
    </message>
    <message>
        <source>No connected encoder is chosen.</source>
        <translation>Kein verbundener Geber ist gewählt.</translation>
    </message>
    <message>
        <source>&amp;Trend</source>
        <translation>&amp;Trend</translation>
    </message>
    <message>
        <source>Draws what encoders show as curves over time; sends nothing</source>
        <translation>Zeichnet, was Geber zeigen, als Kurven über der Zeit; sendet nichts</translation>
    </message>
    <message>
        <source>Recor&amp;d…</source>
        <translation>&amp;Aufzeichnen…</translation>
    </message>
    <message>
        <source>Records what encoders show to a file, or shows the recording that runs; sends nothing</source>
        <translation>Zeichnet in eine Datei auf, was Geber zeigen, oder zeigt die laufende Aufzeichnung; sendet nichts</translation>
    </message>
    <message>
        <source>Record</source>
        <comment>on a button</comment>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Shows a recording in monitor, dial and trace as if it were a bus; sends nothing</source>
        <translation>Zeigt eine Aufzeichnung in Monitor, Scheibe und Protokoll, als wäre sie ein Bus; sendet nichts</translation>
    </message>
    <message>
        <source>C&amp;lose recording</source>
        <translation>Aufzeichnung sch&amp;ließen</translation>
    </message>
    <message>
        <source>Closes the recording that is chosen in the bus structure</source>
        <translation>Schließt die Aufzeichnung, die im Busaufbau gewählt ist</translation>
    </message>
    <message>
        <source>Open recordin&amp;g…</source>
        <translation>Aufz&amp;eichnung öffnen…</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;finden…</translation>
    </message>
    <message>
        <source>Finds actions, devices, parameters, messages and pages of the manual by words</source>
        <translation>Findet Aktionen, Geräte, Parameter, Meldungen und Seiten des Handbuchs über Wörter</translation>
    </message>
    <message>
        <source>Wh&amp;o is there?</source>
        <translation>Wer &amp;ist da?</translation>
    </message>
    <message>
        <source>Looks for encoders and gateways at the ports of this computer and at a host; listens first</source>
        <translation>Sucht Geber und Gateways an den Anschlüssen dieses Rechners und an einem Host; horcht zuerst</translation>
    </message>
    <message>
        <source>W&amp;hy is there no data?</source>
        <translation>Warum kommen &amp;keine Daten?</translation>
    </message>
    <message>
        <source>Shows what is expected of the chosen device or bus beside what came, and what to do; sends nothing</source>
        <translation>Zeigt, was vom gewählten Gerät oder Bus erwartet wird, neben dem, was kam, und was zu tun ist; sendet nichts</translation>
    </message>
    <message>
        <source>no answer, silent, no position, error</source>
        <translation>keine Antwort, stumm, keine Position, Fehler</translation>
    </message>
    <message>
        <source>find, search, scan, baud rate, baudrate, address</source>
        <translation>finden, suchen, Scan, Baudrate, Adresse</translation>
    </message>
    <message>
        <source>set the position, preset, zero point, scaling, parameterization</source>
        <translation>Position setzen, Preset, Nullpunkt, Skalierung, Parametrierung</translation>
    </message>
    <message>
        <source>zero, normal running, run</source>
        <translation>Null, Normalbetrieb, run</translation>
    </message>
    <message>
        <source>curves, CSV, export</source>
        <translation>Kurven, CSV, exportieren</translation>
    </message>
    <message>
        <source>English, language</source>
        <translation>Englisch, Sprache</translation>
    </message>
    <message>
        <source>German, language</source>
        <translation>Deutsch, Sprache</translation>
    </message>
    <message>
        <source>Shows the commissioning report of the project, and saves it as a PDF or a web page; sends nothing</source>
        <translation>Zeigt den Inbetriebnahmebericht des Projekts und speichert ihn als PDF oder Webseite; sendet nichts</translation>
    </message>
</context>
<context>
    <name>codewheel::WizardPage</name>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
</context>
<context>
    <name>codewheel::WordCard</name>
    <message>
        <source>Monitor %1</source>
        <comment>Monitor 1.0</comment>
        <translation>Monitor %1</translation>
    </message>
    <message>
        <source>Pin monitor %1</source>
        <comment>Pin monitor 1.0</comment>
        <translation>Monitor %1 anheften</translation>
    </message>
    <message>
        <source>Keep this monitor when another device is chosen</source>
        <translation>Diesen Monitor behalten, wenn ein anderes Gerät gewählt wird</translation>
    </message>
    <message>
        <source>Choose what all monitors show</source>
        <translation>Wählen, was alle Monitore zeigen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Close monitor %1</source>
        <comment>Close monitor 1.0</comment>
        <translation>Monitor %1 schließen</translation>
    </message>
    <message>
        <source>Close this monitor</source>
        <translation>Diesen Monitor schließen</translation>
    </message>
    <message>
        <source>%1 has no OUT word: nothing can be sent to it.</source>
        <comment>1.0</comment>
        <translation>%1 hat kein OUT-Wort: Es lässt sich nichts dorthin senden.</translation>
    </message>
    <message>
        <source>Copy as hexadecimal</source>
        <translation>Hexadezimal kopieren</translation>
    </message>
    <message>
        <source>%1 has a command bit or a parameter number, so it is not sent at once. Send it?</source>
        <translation>%1 hat ein Befehlsbit oder eine Parameternummer und wird deshalb nicht sofort gesendet. Senden?</translation>
    </message>
    <message>
        <source>Send %1</source>
        <comment>a word</comment>
        <translation>%1 senden</translation>
    </message>
    <message>
        <source>Display of %1</source>
        <comment>Show of 1.0</comment>
        <translation>Anzeige von %1</translation>
    </message>
    <message>
        <source>Show &amp;bit in trend</source>
        <translation>&amp;Bit im Trend zeigen</translation>
    </message>
    <message>
        <source>Show &amp;word in trend</source>
        <translation>&amp;Wort im Trend zeigen</translation>
    </message>
</context>
<context>
    <name>codewheel::WordLine</name>
    <message>
        <source>Not explained: there is no description of this device.</source>
        <translation>Ohne Erklärung: Für dieses Gerät gibt es keine Beschreibung.</translation>
    </message>
    <message>
        <source>Not sent yet: %1</source>
        <comment>meaning of a word</comment>
        <translation>Noch nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Not known what is there.</source>
        <translation>Nicht bekannt, was dort steht.</translation>
    </message>
</context>
<context>
    <name>codewheel::WordReadingsModel</name>
    <message>
        <source>Place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Registers of its IN word</source>
        <translation>Register seines IN-Wortes</translation>
    </message>
    <message>
        <source>IN</source>
        <translation>IN</translation>
    </message>
    <message>
        <source>Registers of its OUT word</source>
        <translation>Register seines OUT-Wortes</translation>
    </message>
    <message>
        <source>OUT</source>
        <translation>OUT</translation>
    </message>
    <message>
        <source>High word first</source>
        <translation>Oberes Wort zuerst</translation>
    </message>
    <message>
        <source>Low word first</source>
        <translation>Unteres Wort zuerst</translation>
    </message>
    <message>
        <source>High word first, with the bytes of each register exchanged: the gateway has a setting for that</source>
        <translation>Oberes Wort zuerst, mit vertauschten Bytes in jedem Register: Das Gateway hat eine Einstellung dafür</translation>
    </message>
    <message>
        <source>Low word first, with the bytes of each register exchanged: the gateway has a setting for that</source>
        <translation>Unteres Wort zuerst, mit vertauschten Bytes in jedem Register: Das Gateway hat eine Einstellung dafür</translation>
    </message>
    <message>
        <source>%1 (set)</source>
        <translation>%1 (gilt)</translation>
    </message>
</context>
<context>
    <name>codewheel::WordSender</name>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>At once</source>
        <translation>Sofort</translation>
    </message>
    <message>
        <source>Write %1</source>
        <comment>Write OUT 1.0</comment>
        <translation>Schreiben: %1</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <comment>Discard OUT 1.0</comment>
        <translation>Verwerfen: %1</translation>
    </message>
    <message>
        <source>Send %1 at once</source>
        <comment>Send OUT 1.0 at once</comment>
        <translation>%1 sofort senden</translation>
    </message>
    <message>
        <source>Send each change as it is made. Words with a parameter number or a command bit still ask.</source>
        <translation>Jede Änderung sofort senden. Bei Worten mit Parameternummer oder Befehlsbit wird trotzdem gefragt.</translation>
    </message>
    <message>
        <source>Send this word to the encoder; it stays there until another is sent (Ctrl+Return)</source>
        <translation>Dieses Wort an den Geber senden; es steht dort, bis ein anderes gesendet wird (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Back to the word on the bus (Esc)</source>
        <translation>Zurück zum Wort, das auf dem Bus steht (Esc)</translation>
    </message>
</context>
<context>
    <name>codewheel::WordView</name>
    <message>
        <source>%1 bit %2</source>
        <comment>OUT 1.0 bit 25</comment>
        <translation>%1 Bit %2</translation>
    </message>
    <message>
        <source>Not sent yet</source>
        <translation>Noch nicht gesendet</translation>
    </message>
    <message>
        <source>%1 (not sent yet)</source>
        <comment>meaning of a bit</comment>
        <translation>%1 (noch nicht gesendet)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>bit: meaning</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>%1 bits</source>
        <comment>OUT 1.0, IN 1.0 bits</comment>
        <translation>Bits %1</translation>
    </message>
    <message>
        <source>%1 bit %2</source>
        <translation>%1 Bit %2</translation>
    </message>
    <message>
        <source>To the next bit</source>
        <translation>Zum nächsten Bit</translation>
    </message>
    <message>
        <source>To the highest or the lowest bit</source>
        <translation>Zum höchsten oder niedrigsten Bit</translation>
    </message>
    <message>
        <source>Toggles a bit of OUT</source>
        <translation>Schaltet ein Bit von OUT um</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>codewheel::WriteReview</name>
    <message>
        <source>Sends these words, then run (80000000)</source>
        <translation>Sendet diese Worte, dann Run (80000000)</translation>
    </message>
    <message>
        <source>&amp;Write this value</source>
        <translation>Diesen Wert &amp;schreiben</translation>
    </message>
    <message>
        <source>&amp;Write these %1 values</source>
        <translation>Diese %1 Werte &amp;schreiben</translation>
    </message>
    <message>
        <source>The encoder is known to have all wanted values. There is nothing to write.</source>
        <translation>Alle gewünschten Werte stehen schon im Geber. Es gibt nichts zu schreiben.</translation>
    </message>
    <message>
        <source>Left out because they are there already: %1.</source>
        <translation>Entfallen, weil schon vorhanden: %1.</translation>
    </message>
    <message>
        <source>The preset acts once it is initialised (40000000).</source>
        <translation>Der Preset wirkt erst, wenn er initialisiert wird (40000000).</translation>
    </message>
    <message>
        <source>Sends these words, each with its handshake on the service bit</source>
        <translation>Sendet diese Worte, jedes mit seinem Handshake am Dienst-Bit</translation>
    </message>
    <message>
        <source>Sends these requests, and reads back each value</source>
        <translation>Sendet diese Anfragen und liest jeden Wert zurück</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>What will be sent, between ESC and CR LF</source>
        <translation>Was gesendet wird, zwischen ESC und CR LF</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfrage</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Wort</translation>
    </message>
    <message>
        <source>The word that will be in OUT</source>
        <translation>Das Wort, das dann in OUT steht</translation>
    </message>
    <message>
        <source>Sends this; the encoder confirms it, and cannot be read</source>
        <translation>Sendet dies; der Geber quittiert es und lässt sich nicht auslesen</translation>
    </message>
    <message>
        <source>The encoder had all wanted values when it was seen last. Whether it has them now is not known: %1</source>
        <comment>a sentence</comment>
        <translation>Als der Geber zuletzt zu sehen war, hatte er alle gewünschten Werte. Ob er sie jetzt hat, ist nicht bekannt: %1</translation>
    </message>
</context>
<context>
    <name>codewheel::WriteWords</name>
    <message>
        <source>The encoder is read first; what it already has is not written again.</source>
        <translation>Der Geber wird zuerst ausgelesen; was er schon hat, wird nicht noch einmal geschrieben.</translation>
    </message>
    <message>
        <source>If the encoder counts steps minus 1, the word for the steps is one less.</source>
        <translation>Zählt der Geber Schritte minus 1, ist das Wort für die Schritte um eins kleiner.</translation>
    </message>
    <message>
        <source>The encoder has lost its parameters (error 3), and works again only with all of parameters 1 to 4. Without a value: %1. Want these too, or reset it to its default values.</source>
        <translation>Der Geber hat seine Parameter verloren (Fehler 3) und arbeitet erst wieder mit allen Parametern 1 bis 4. Ohne Wert: %1. Auch diese vorgeben, oder ihn auf seine Standardwerte zurücksetzen.</translation>
    </message>
    <message>
        <source>The encoder takes all its values at once. These go along as they are known, otherwise as from the factory: %1.</source>
        <translation>Der Geber nimmt alle Werte auf einmal. Diese gehen mit, wie sie bekannt sind, sonst wie ab Werk: %1.</translation>
    </message>
    <message>
        <source>In force already; only stored, since that may not have been done: %1.</source>
        <translation>Gilt schon; wird nur gespeichert, da das vielleicht noch nicht geschehen ist: %1.</translation>
    </message>
</context>
</TS>
