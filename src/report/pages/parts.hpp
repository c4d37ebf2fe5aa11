// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <pugixml.hpp>

#include <carom/report/pages/document.hpp>
#include <carom/report/results/run.hpp>

/// The parts of pages.
namespace carom::report {

/// Counts JUnit's tests below the node, which is a suite or the root. `seconds` is the time in which subjects answered.
void set_totals(pugi::xml_node node, double seconds);

enum class Subjects { counting, all };

/// Adds a row for each subject. The subjects that count (that decide the exit status) are first, and the others follow
/// below a heading.
void add_subject_rows(Table& table, const Run& run, Subjects which, const std::function<Row(std::size_t)>& row_of);

/// One row for each subject: verdict, worst backward error, digits, time.
[[nodiscard]] Table subjects_table(const Run& run, Subjects which);

/// A command, which no line end may break.
[[nodiscard]] Cell command_cell(std::string command);

/// The reasons why subjects could not be judged, or not to the end, each with the anchor that subjects_table links to.
[[nodiscard]] Document errors_part(const Run& run);

/// The fault of the judge that ended the run; empty if there was none.
[[nodiscard]] Document judge_error_part(const Run& run);

/// One row for each family: the number of its cases that collide, rest, separate, ….
[[nodiscard]] Table coverage_table(const Run& run);

/// The number of pairs of features in colliding cases, beside that of a long run.
[[nodiscard]] std::string features_in_words(const Run& run);

/// The number of colliding cases that have each feature.
[[nodiscard]] Table features_table(const Run& run);

/// The number of cases in which each subject keeps or violates each invariant.
[[nodiscard]] Document invariants_part(const Run& run);

/// Each claim that a subject does not make, with the reason; empty if every subject makes every claim.
[[nodiscard]] Document deviations_part(const Run& run);

/// The claimed invariants of each sound subject that no case judged; empty if there are none.
[[nodiscard]] Document never_judged_part(const Run& run);

/// The worst backward error of each subject in each family.
[[nodiscard]] Document families_part(const Run& run);

/// For families beyond the domain that solvers claim: the value of the quantity from which each subject fails. This
/// boundary is no verdict. Empty if no such family was posed.
[[nodiscard]] Document beyond_domain_part(const Run& run, Subjects which);

/// The boundary of one subject on one family beyond the domain: "from 3.2e+07 on: 412 of 1000".
[[nodiscard]] std::string boundary_in_words(const properties::FamilyResult& family);

/// A terminal has no room for everything.
enum class Form { terminal, summary, page };

/// The faults of the subject at this place. The section begins with the first fault in a sentence, a short case, the
/// place to check, and the command that replays it. Precondition: the subject has violations.
[[nodiscard]] Section finding_part(const Run& run, std::size_t s, const std::string& out_directory, Form form);

/// `finding_part` of each subject with violations, for a page.
[[nodiscard]] Document findings_part(const Run& run, const std::string& out_directory);

/// The families with violations of each subject that counts; empty if there are none.
[[nodiscard]] Document violated_families_part(const Run& run);

/// The energy that the answers of each subject gain. Empty if none was measured.
[[nodiscard]] Document energy_part(const Run& run);

/// For each subject that counts, the families and the features with violations of each invariant.
[[nodiscard]] Document violations_part(const Run& run);

/// Every witness in full, with its picture.
[[nodiscard]] Document witnesses_part(const Run& run, const std::string& out_directory);

/// The anchor of a witness. `subject` is its index in the run.
[[nodiscard]] std::string witness_anchor(std::size_t subject, const properties::Invariant& invariant);

/// The differences between two runs, without the summary. `has_known` asks for the known violations too.
[[nodiscard]] Document comparison_part(const Comparison& comparison, bool has_known);

/// The families that have no case in the domain, in a sentence; empty if there are none.
[[nodiscard]] std::string without_case_in_words(const Run& run);

/// Why a witness was not simplified. Precondition: `not_shrunk` is not empty.
[[nodiscard]] std::string not_shrunk_in_words(const properties::Witness& witness);

/// The command that replays the witness in the directory, or, if there is no directory, the case as it was drawn.
[[nodiscard]] std::string replay_line(const Run& run, const Subject& subject, const properties::Witness& witness,
                                      const std::string& out_directory);

}  // namespace carom::report
