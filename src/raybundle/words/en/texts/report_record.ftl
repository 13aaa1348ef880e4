report_record-title = Recording sheet

report_record-entry = entry

report_record-record = record

# $part = "object"
report_record-part = { $part ->
        [object] Object
        [recording] Recording
        *[delivery] Delivery
    }

report_record-from_photographs = from the photographs

report_record-sources = Object: after the Core Data Index to Historic Buildings and Monuments (Council of Europe, CIDOC).
    .why = Recording: after the 3x3 rules of CIPA.

# $name = "control"
report_record-name = { $name ->
        [title] Title
        [client] Client
        [operator] Operator
        [object] Object
        [place] Place
        [date] Date
        [instruments] Instruments
        [rights] Rights
        [reference] Reference
        [kind] Kind
        [dating] Dating
        [persons] Persons
        [materials] Materials
        [condition] Condition
        [protection] Protection
        [description] Description
        [purpose] Purpose
        [conditions] Conditions
        [control] Control and scale
        *[archive] Archive
    }
