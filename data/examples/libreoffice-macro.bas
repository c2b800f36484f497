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
    Dim address As Object
    Dim sheet As Object
    Dim arguments As String
    Dim i As Long
    Dim k As Long
    paths = Split(ANSWERS, " ")
    batch = ScratchName(".csv")
    WriteText(batch, TableAsCsv(table))
    arguments = "-q --batch """ & batch & """"
    For k = 0 To UBound(paths)
        arguments = arguments & " --get " & paths(k)
    Next k
    lines = AnswerLines(arguments)
    Kill batch
    address = table.getRangeAddress()
    sheet = table.getSpreadsheet()
    For k = 0 To UBound(paths)
        sheet.getCellByPosition(address.EndColumn + 1 + k, address.StartRow).setString(paths(k))
    Next k
    For i = 0 To UBound(lines)
        values = Split(lines(i), Chr(9))
        For k = 0 To UBound(values)
            If values(k) = "null" Then
                sheet.getCellByPosition(address.EndColumn + 1 + k, address.StartRow + 1 + i).setString("no answer")
            Else
                sheet.getCellByPosition(address.EndColumn + 1 + k, address.StartRow + 1 + i).setValue(Val(values(k)))
            End If
        Next k
    Next i
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
        ' A last line that is empty is what stands behind the last line end.
        If text <> "" Then
            ReDim Preserve found(count)
            found(count) = text
            count = count + 1
        End If
    Loop
    Close #handle
    Kill file
    If count = 0 Then
        AnswerLines = Array()
    Else
        AnswerLines = found
    End If
End Function

Function NumberIn(text As String) As Variant
    If text = "null" Then
        NumberIn = "no answer"
    ElseIf InStr("-0123456789", Left(text, 1)) > 0 Then
        NumberIn = Val(text)
    Else
        NumberIn = text
    End If
End Function

' Comma-separated with decimal points, whatever the locale; texts in quotes.
Function TableAsCsv(table As Object) As String
    Dim csv As String
    Dim cell As Object
    Dim row As Long
    Dim column As Long
    For row = 0 To table.getRows().getCount() - 1
        For column = 0 To table.getColumns().getCount() - 1
            If column > 0 Then csv = csv & ","
            cell = table.getCellByPosition(column, row)
            If cell.getString() = "" Then
                csv = csv & ""
            ElseIf HoldsNumber(cell) Then
                csv = csv & Trim(Str(cell.getValue()))
            Else
                csv = csv & """" & Join(Split(cell.getString(), """"), """""") & """"
            End If
        Next column
        csv = csv & Chr(10)
    Next row
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
