// The sorts of inquiry that there are: studies and designs.
#pragma once

#include "core/design/design.h"
#include "core/study/study.h"
#include "ui/run/inquiry_runner.h"

namespace covaria::ui {

using StudyRunner = InquiriesOf<StudyResult>;
using StudyStatus = InquiryStatus<StudyResult>;
using StudyPointer = std::shared_ptr<const StudyResult>;
using DesignRunner = InquiriesOf<DesignResult>;
using DesignStatus = InquiryStatus<DesignResult>;
using DesignPointer = std::shared_ptr<const DesignResult>;

InquiryKind study_inquiries();
InquiryKind design_inquiries();

}  // namespace covaria::ui
