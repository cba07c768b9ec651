# Which suites of the GoogleTest program share a ctest entry, and with it the cached solutions and sheets of the
# examples (support/solved.hpp, support/laid_out.hpp), and which run under sanitizers. Names are regular expressions.

set(suites_of_sheets "Sheet.*|Lying/OverlapOnPaper|Bands|Theme|FigureOne|Brief|.*DataStatement")
set(suites_of_steps_and_upright "Upright/OverlapOnPaper|Examples/Steps|Steps.*|Handouts")
set(suites_of_figures "MechanismFigure|OnMechanism|Labels|Polygon.*|.*FigureAlone.*|.*LoadedExample.*|Symbols|CircleDiagram")
set(suites_of_commands "CommandLine|Batch.*|Sweep.*|SolveAt|.*Command|SameBytes|TexFiles|LiveFiles|DxfFiles|FilmFiles|SlidesFiles|QuizFiles|HandoutLine|AnswersLine|.*Commands|MotionOnTheCommandLine")
set(kinegraph_suite_groups sheets steps_and_upright figures commands)

# Under sanitizers: the suites that read files and texts, solve and lay out. `tests/run --sanitize --all` runs the
# others too.
set(kinegraph_sanitized_suites
    Reader JsonSource Gate Formula FormulaSyntax Parameters Units Decimals Exact Root Found/.* ".*/Found" Pose Positions Mobility Branches
    Cam Program Forces Derivative Trusses Equations.* EquationsAsJson NamedResults Variants Cycle WorkedArithmetic Examples
    ForceLaws ForceExamples HigherPairs Hertz Impact Rotor PointMotion Displacements VirtualWork ".*Superposed" RandomChains1 RandomMechanisms1
    RandomForces1 RoundedDegenerateMechanisms Sheet "Sheet/EveryExample" "Lying/OverlapOnPaper" Handouts "Examples/Steps" RandomPages1
    Svg Backends Png Pdf Picture Markup LiveText Tex Type Utf8 DiffCommand QuizOf PublicFace)
list(JOIN kinegraph_sanitized_suites "|" kinegraph_sanitized_suites)

# has_sanitized_suite(FILE VARIABLE): whether the file has a test of one of these suites.
function(has_sanitized_suite file variable)
    file(STRINGS ${file} lines REGEX "^(TEST|TEST_F|TEST_P|TYPED_TEST|INSTANTIATE_TEST_SUITE_P)\\(")
    set(${variable} FALSE PARENT_SCOPE)
    foreach(line IN LISTS lines)
        string(REGEX MATCH "\\(([A-Za-z0-9_]+)(, *([A-Za-z0-9_]+))?" found "${line}")
        foreach(suite "${CMAKE_MATCH_1}" "${CMAKE_MATCH_1}/${CMAKE_MATCH_3}")
            if(suite MATCHES "^(${kinegraph_sanitized_suites})$")
                set(${variable} TRUE PARENT_SCOPE)
            endif()
        endforeach()
    endforeach()
endfunction()

# Sanitizers keep freed memory to detect its use, so the memory of a process grows and these suites would fail.
set(kinegraph_unsanitized_suites "BatchMemory")
