REM Predictions in LibreOffice Calc, by the bioprint-predict command.
REM
REM   =BIOPRINTPREDICT("--radius 50um --flowrate 141uL/h"; "nozzle.stress_max")
REM
REM is one value in SI units. PredictSelection answers a selected table whose first row names options, such as
REM "radius [um]", "flowrate [uL/h]", "alpha", and writes the values of ANSWERS to the right of it.
REM
REM To install: Tools > Macros > Edit Macros, a new module in My Macros & Dialogs > Standard, paste this file.
REM PROGRAM may need a full path.
REM
REM Shell returns no output, so the answer goes through a file. Numbers are written by Str and read by Val, which
REM always use the decimal point; CStr and CDbl follow the locale.

Option Explicit

Const PROGRAM = "bioprint-predict"
Const ANSWERS = "nozzle.stress_max exit.elongational_stress nozzle.pressure_gradient"

Function BioprintPredict(question As String, path As String) As Variant
    Dim lines As Variant
    lines = AnswerLines("-q " & question & " --get " & path)
    If UBound(lines) < 0 Then
        BioprintPredict = "no answer; try it in a terminal: " & PROGRAM & " " & question
    Else
        BioprintPredict = NumberIn(lines(0))
    End If
End Function

Sub PredictSelection
    Dim selection As Object
    selection = ThisComponent.getCurrentSelection()
    If Not selection.supportsService("com.sun.star.sheet.SheetCellRange") Then
        MsgBox "Select a table first; its first row names options."
        Exit Sub
    End If
    PredictRange(selection)
End Sub

Sub PredictRange(table As Object)
    Dim batch As String
    Dim lines As Variant
    Dim paths As Variant
    Dim values As Variant
    Dim filled As Variant
    Dim address As Object
    Dim sheet As Object
    Dim arguments As String
    Dim i As Long
    Dim k As Long
    paths = Split(ANSWERS, " ")
    filled = FilledRows(table)
    If UBound(filled) < 1 Then
        MsgBox "Select a table first; its first row names options."
        Exit Sub
    End If
    batch = ScratchName(".csv")
    WriteText(batch, TableAsCsv(table, filled))
    arguments = "-q --batch """ & batch & """"
    For k = 0 To UBound(paths)
        arguments = arguments & " --get " & paths(k)
    Next k
    lines = AnswerLines(arguments)
    Kill batch
    address = table.getRangeAddress()
    sheet = table.getSpreadsheet()
    For k = 0 To UBound(paths)
        sheet.getCellByPosition(address.EndColumn + 1 + k, address.StartRow + filled(0)).setString(paths(k))
    Next k
    For i = 1 To UBound(filled)
        ' One line for each row; with any other number nobody knows whose they are.
        If UBound(lines) = UBound(filled) - 1 Then
            values = Split(lines(i - 1), Chr(9))
        Else
            values = Array("null")
        End If
        For k = 0 To UBound(values)
            PutValue(sheet.getCellByPosition(address.EndColumn + 1 + k, address.StartRow + filled(i)), NumberIn(values(k)))
        Next k
    Next i
End Sub

' 5 is the type of a number.
Sub PutValue(cell As Object, value As Variant)
    If VarType(value) = 5 Then
        cell.setValue(value)
    Else
        cell.setString(value)
    End If
End Sub

' The lines the command writes with these arguments; none when it has no answer.
Function AnswerLines(arguments As String) As Variant
    Dim file As String
    Dim handle As Integer
    Dim text As String
    Dim found() As String
    Dim count As Long
    file = ScratchName(".txt")
    Shell(PROGRAM, 0, arguments & " --output """ & file & """", True)
    If Not FileExists(file) Then
        AnswerLines = Array()
        Exit Function
    End If
    handle = FreeFile
    Open file For Input As #handle
    count = 0
    Do While Not Eof(handle)
        Line Input #handle, text
        ReDim Preserve found(count)
        found(count) = text
        count = count + 1
    Loop
    Close #handle
    Kill file
    ' A last line that is empty is what stands behind the last line end.
    If count > 0 Then
        If found(count - 1) = "" Then count = count - 1
    End If
    If count = 0 Then
        AnswerLines = Array()
    Else
        ReDim Preserve found(count - 1)
        AnswerLines = found
    End If
End Function

Function NumberIn(text As String) As Variant
    If text = "null" Then
        NumberIn = "no answer"
    ElseIf IsNumber(text) Then
        NumberIn = Val(text)
    Else
        NumberIn = text
    End If
End Function

' As the command writes them. A name may begin with a digit.
Function IsNumber(text As String) As Boolean
    Dim i As Long
    IsNumber = False
    If text = "" Then Exit Function
    If InStr("-0123456789", Left(text, 1)) = 0 Then Exit Function
    For i = 1 To Len(text)
        If InStr("-+.e0123456789", Mid(text, i, 1)) = 0 Then Exit Function
    Next i
    IsNumber = True
End Function

' The rows of the table that hold anything, the names first. An empty one asks nothing and has no answer.
Function FilledRows(table As Object) As Variant
    Dim found() As Long
    Dim count As Long
    Dim row As Long
    Dim column As Long
    count = 0
    For row = 0 To table.getRows().getCount() - 1
        For column = 0 To table.getColumns().getCount() - 1
            If Trim(table.getCellByPosition(column, row).getString()) <> "" Then
                ReDim Preserve found(count)
                found(count) = row
                count = count + 1
                Exit For
            End If
        Next column
    Next row
    If count = 0 Then
        FilledRows = Array()
    Else
        FilledRows = found
    End If
End Function

' Comma-separated with decimal points, whatever the locale; texts in quotes.
Function TableAsCsv(table As Object, filled As Variant) As String
    Dim csv As String
    Dim cell As Object
    Dim i As Long
    Dim column As Long
    For i = 0 To UBound(filled)
        For column = 0 To table.getColumns().getCount() - 1
            If column > 0 Then csv = csv & ","
            cell = table.getCellByPosition(column, filled(i))
            If cell.getString() = "" Then
                csv = csv & ""
            ElseIf HoldsNumber(cell) Then
                csv = csv & Trim(Str(cell.getValue()))
            Else
                csv = csv & """" & Join(Split(cell.getString(), """"), """""") & """"
            End If
        Next column
        csv = csv & Chr(10)
    Next i
    TableAsCsv = csv
End Function

Function HoldsNumber(cell As Object) As Boolean
    If cell.getType() = com.sun.star.table.CellContentType.VALUE Then
        HoldsNumber = True
    ElseIf cell.getType() = com.sun.star.table.CellContentType.FORMULA Then
        HoldsNumber = cell.FormulaResultType2 = com.sun.star.sheet.FormulaResult.VALUE
    Else
        HoldsNumber = False
    End If
End Function

Function ScratchName(ending As String) As String
    Static count As Long
    Dim settings As Object
    count = count + 1
    settings = createUnoService("com.sun.star.util.PathSettings")
    ScratchName = ConvertFromURL(settings.Temp & "/bioprint-" & Format(Now(), "yyyymmddhhmmss") & "-" & _
        Trim(Str(Int(Rnd() * 1000000))) & "-" & Trim(Str(count)) & ending)
End Function

Sub WriteText(file As String, text As String)
    Dim files As Object
    Dim stream As Object
    files = createUnoService("com.sun.star.ucb.SimpleFileAccess")
    stream = createUnoService("com.sun.star.io.TextOutputStream")
    stream.setOutputStream(files.openFileWrite(ConvertToURL(file)))
    stream.setEncoding("UTF-8")
    stream.writeString(text)
    stream.closeOutput()
End Sub
