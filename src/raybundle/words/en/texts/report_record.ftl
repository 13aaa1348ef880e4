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

# $name = "title"
report_record-meaning = { $name ->
        [title] title of the delivery
        [client] client
        [operator] photographer or operator of the adjustment
        [object] name of the object
        [place] address, parish, country
        [date] date of the photographs
        [instruments] cameras, lenses, receivers, scale bars
        [rights] licence or owner of the result
        [reference] inventory and order numbers
        [kind] type and use of the object
        [dating] period, century or years
        [persons] maker, owners, alterations by
        [materials] materials and techniques
        [condition] state of the object
        [protection] legal status
        [description] further description
        [purpose] purpose of the recording
        [conditions] weather, light and access
        [control] measurement of scale, control and vertical
        *[archive] keeper of the recording, and place
    }
