struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: array<u32>,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_23 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(2)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_19;
fn function_() {
var local: f32;
var local_1: f32;
let _e104 = global;
let _e112 = global_1.member.member_2;
let _e115 = global_1.member.member;
let _e123 = (_e104.x + _e112.member);
let _e125 = (_e104.y + _e112.member_1);
if (_e123 < _e112.member_2) {
if (_e125 < _e112.member_3) {
let _e128 = (_e115.member * _e115.member_1);
let _e130 = ((_e125 * _e115.member) + _e123);
let _e131 = bitcast<i32>(_e130);
let _e133 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e135 = select(_e133, _e131, (_e131 < _e133));
let _e141 = global_2.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e142 = (_e128 + _e130);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e133, _e143, (_e143 < _e133));
let _e151 = global_2.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((2u * _e128) + _e130);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e133, _e154, (_e154 < _e133));
let _e162 = global_2.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((3u * _e128) + _e130);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e133, _e165, (_e165 < _e133));
let _e173 = global_2.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((4u * _e128) + _e130);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e133, _e176, (_e176 < _e133));
let _e184 = global_2.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((5u * _e128) + _e130);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e133, _e187, (_e187 < _e133));
let _e195 = global_2.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((6u * _e128) + _e130);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e133, _e198, (_e198 < _e133));
let _e206 = global_2.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((7u * _e128) + _e130);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e133, _e209, (_e209 < _e133));
let _e217 = global_2.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((8u * _e128) + _e130);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e133, _e220, (_e220 < _e133));
let _e228 = global_2.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((13u * _e128) + _e130);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e133, _e231, (_e231 < _e133));
let _e239 = global_2.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((14u * _e128) + _e130);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e133, _e242, (_e242 < _e133));
let _e250 = global_2.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((15u * _e128) + _e130);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e133, _e253, (_e253 < _e133));
let _e261 = global_2.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((16u * _e128) + _e130);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e133, _e264, (_e264 < _e133));
let _e272 = global_2.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((17u * _e128) + _e130);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e133, _e275, (_e275 < _e133));
let _e283 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((18u * _e128) + _e130);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e133, _e286, (_e286 < _e133));
let _e294 = global_2.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((19u * _e128) + _e130);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e133, _e297, (_e297 < _e133));
let _e305 = global_2.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((20u * _e128) + _e130);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e133, _e308, (_e308 < _e133));
let _e316 = global_2.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((21u * _e128) + _e130);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e133, _e319, (_e319 < _e133));
let _e327 = global_2.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((22u * _e128) + _e130);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e133, _e330, (_e330 < _e133));
let _e338 = global_2.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
if (select(3u, 0u, (_e283 == -1.2676506e30f)) > 1u) {
let _e343 = (_e115.member_2 == 2u);
let _e347 = select(_e206, (_e206 / select(1e-30f, _e228, (_e228 > 1e-30f))), _e343);
local_1 = _e347;
let _e348 = local_1;
let _e350 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e352 = select(_e350, 263171i, (263171i < _e350));
let _e357 = global_3.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e358 = bitcast<f32>(_e357);
let _e360 = select(_e350, 263172i, (263172i < _e350));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e366 = bitcast<f32>(_e365);
let _e368 = select(_e350, 263173i, (263173i < _e350));
let _e373 = global_3.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e374 = bitcast<f32>(_e373);
let _e376 = ((_e348 - _e358) * _e366);
let _e378 = select(0f, _e376, (_e376 > 0f));
let _e381 = local_1;
let _e383 = select(_e350, 263174i, (263174i < _e350));
let _e388 = global_3.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e389 = bitcast<f32>(_e388);
let _e391 = select(_e350, 263175i, (263175i < _e350));
let _e396 = global_3.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = bitcast<f32>(_e396);
let _e399 = select(_e350, 263176i, (263176i < _e350));
let _e404 = global_3.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e405 = bitcast<f32>(_e404);
let _e407 = ((_e381 - _e389) * _e397);
let _e409 = select(0f, _e407, (_e407 > 0f));
let _e413 = local_1;
let _e415 = select(_e350, 263177i, (263177i < _e350));
let _e420 = global_3.member[bitcast<u32>(select(0i, _e415, (_e415 > 0i)))];
let _e421 = bitcast<f32>(_e420);
let _e423 = select(_e350, 263178i, (263178i < _e350));
let _e428 = global_3.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e429 = bitcast<f32>(_e428);
let _e431 = select(_e350, 263179i, (263179i < _e350));
let _e436 = global_3.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e437 = bitcast<f32>(_e436);
let _e439 = ((_e413 - _e421) * _e429);
let _e441 = select(0f, _e439, (_e439 > 0f));
let _e444 = local_1;
let _e446 = select(_e350, 263180i, (263180i < _e350));
let _e451 = global_3.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e452 = bitcast<f32>(_e451);
let _e454 = select(_e350, 263181i, (263181i < _e350));
let _e459 = global_3.member[bitcast<u32>(select(0i, _e454, (_e454 > 0i)))];
let _e460 = bitcast<f32>(_e459);
let _e462 = select(_e350, 263182i, (263182i < _e350));
let _e467 = global_3.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e468 = bitcast<f32>(_e467);
let _e470 = ((_e444 - _e452) * _e460);
let _e472 = select(0f, _e470, (_e470 > 0f));
let _e477 = local_1;
let _e479 = select(_e350, 263183i, (263183i < _e350));
let _e484 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e485 = bitcast<f32>(_e484);
let _e487 = select(_e350, 263184i, (263184i < _e350));
let _e492 = global_3.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e493 = bitcast<f32>(_e492);
let _e495 = select(_e350, 263185i, (263185i < _e350));
let _e500 = global_3.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e501 = bitcast<f32>(_e500);
let _e503 = ((_e477 - _e485) * _e493);
let _e505 = select(0f, _e503, (_e503 > 0f));
let _e508 = local_1;
let _e510 = select(_e350, 263186i, (263186i < _e350));
let _e515 = global_3.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e516 = bitcast<f32>(_e515);
let _e518 = select(_e350, 263187i, (263187i < _e350));
let _e523 = global_3.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e524 = bitcast<f32>(_e523);
let _e526 = select(_e350, 263188i, (263188i < _e350));
let _e531 = global_3.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e532 = bitcast<f32>(_e531);
let _e534 = ((_e508 - _e516) * _e524);
let _e536 = select(0f, _e534, (_e534 > 0f));
let _e540 = local_1;
let _e542 = select(_e350, 263189i, (263189i < _e350));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e548 = bitcast<f32>(_e547);
let _e550 = select(_e350, 263190i, (263190i < _e350));
let _e555 = global_3.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e556 = bitcast<f32>(_e555);
let _e558 = select(_e350, 263191i, (263191i < _e350));
let _e563 = global_3.member[bitcast<u32>(select(0i, _e558, (_e558 > 0i)))];
let _e564 = bitcast<f32>(_e563);
let _e566 = ((_e540 - _e548) * _e556);
let _e568 = select(0f, _e566, (_e566 > 0f));
let _e571 = local_1;
let _e573 = select(_e350, 263192i, (263192i < _e350));
let _e578 = global_3.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e579 = bitcast<f32>(_e578);
let _e581 = select(_e350, 263193i, (263193i < _e350));
let _e586 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = bitcast<f32>(_e586);
let _e589 = select(_e350, 263194i, (263194i < _e350));
let _e594 = global_3.member[bitcast<u32>(select(0i, _e589, (_e589 > 0i)))];
let _e595 = bitcast<f32>(_e594);
let _e597 = ((_e571 - _e579) * _e587);
let _e599 = select(0f, _e597, (_e597 > 0f));
let _e604 = (((select(_e374, _e378, (_e378 < _e374)) + select(_e405, _e409, (_e409 < _e405))) + (select(_e437, _e441, (_e441 < _e437)) + select(_e468, _e472, (_e472 < _e468)))) + ((select(_e501, _e505, (_e505 < _e501)) + select(_e532, _e536, (_e536 < _e532))) + (select(_e564, _e568, (_e568 < _e564)) + select(_e595, _e599, (_e599 < _e595)))));
local = _e347;
let _e605 = local;
let _e607 = ((_e605 - _e358) * _e366);
let _e609 = select(0f, _e607, (_e607 > 0f));
let _e612 = local;
let _e614 = ((_e612 - _e389) * _e397);
let _e616 = select(0f, _e614, (_e614 > 0f));
let _e620 = local;
let _e622 = ((_e620 - _e421) * _e429);
let _e624 = select(0f, _e622, (_e622 > 0f));
let _e627 = local;
let _e629 = ((_e627 - _e452) * _e460);
let _e631 = select(0f, _e629, (_e629 > 0f));
let _e636 = local;
let _e638 = ((_e636 - _e485) * _e493);
let _e640 = select(0f, _e638, (_e638 > 0f));
let _e643 = local;
let _e645 = ((_e643 - _e516) * _e524);
let _e647 = select(0f, _e645, (_e645 > 0f));
let _e651 = local;
let _e653 = ((_e651 - _e548) * _e556);
let _e655 = select(0f, _e653, (_e653 > 0f));
let _e658 = local;
let _e660 = ((_e658 - _e579) * _e587);
let _e662 = select(0f, _e660, (_e660 > 0f));
let _e667 = (((select(_e374, _e609, (_e609 < _e374)) + select(_e405, _e616, (_e616 < _e405))) + (select(_e437, _e624, (_e624 < _e437)) + select(_e468, _e631, (_e631 < _e468)))) + ((select(_e501, _e640, (_e640 < _e501)) + select(_e532, _e647, (_e647 < _e532))) + (select(_e564, _e655, (_e655 < _e564)) + select(_e595, _e662, (_e662 < _e595)))));
let _e668 = (255f - 1f);
let _e670 = select(0f, _e604, (_e604 > 0f));
let _e672 = select(_e668, _e670, (_e670 < _e668));
let _e679 = select(0i, select(select(i32(_e672), i32(-2147483648), (_e672 < -2147483600f)), 2147483647i, (_e672 > 2147483500f)), (_e672 == _e672));
let _e683 = (_e679 - select(0i, 1i, (_e672 < f32(_e679))));
let _e685 = select(0f, _e667, (_e667 > 0f));
let _e687 = select(_e668, _e685, (_e685 < _e668));
let _e694 = select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < -2147483600f)), 2147483647i, (_e687 > 2147483500f)), (_e687 == _e687));
let _e698 = (_e694 - select(0i, 1i, (_e687 < f32(_e694))));
let _e700 = select(_e350, 263195i, (263195i < _e350));
let _e706 = global_3.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e707 = bitcast<f32>(_e706);
let _e709 = select(_e350, 263196i, (263196i < _e350));
let _e715 = global_3.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e716 = bitcast<f32>(_e715);
let _e717 = (_e347 - _e347);
let _e723 = (1f / select(_e717, 1f, (bitcast<f32>((bitcast<u32>(_e717) & 2147483647u)) < 1e-20f)));
let _e725 = select(_e707, _e347, (_e347 < _e707));
let _e727 = ((_e725 - _e725) * _e723);
let _e729 = select(_e716, _e347, (_e347 > _e716));
let _e731 = ((_e729 - _e729) * _e723);
let _e734 = (((_e683 * 256i) + _e698) * 4i);
let _e736 = (_e604 - f32(_e683));
let _e738 = (_e667 - f32(_e698));
let _e740 = (1f - (_e727 + _e731));
let _e741 = (_e734 + 1i);
let _e743 = select(_e350, _e741, (_e741 < _e350));
let _e749 = global_3.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e756 = (bitcast<f32>((((_e749 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e757 = (_e734 + 5i);
let _e759 = select(_e350, _e757, (_e757 < _e350));
let _e765 = global_3.member[bitcast<u32>(select(0i, _e759, (_e759 > 0i)))];
let _e773 = (_e734 + 1025i);
let _e775 = select(_e350, _e773, (_e773 < _e350));
let _e781 = global_3.member[bitcast<u32>(select(0i, _e775, (_e775 > 0i)))];
let _e788 = (bitcast<f32>((((_e781 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e789 = (_e734 + 1029i);
let _e791 = select(_e350, _e789, (_e789 < _e350));
let _e797 = global_3.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e807 = (_e756 + (((bitcast<f32>((((_e765 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e756) * _e738));
let _e815 = select(_e350, 1i, (1i < _e350));
let _e821 = global_3.member[bitcast<u32>(select(0i, _e815, (_e815 > 0i)))];
let _e830 = select(_e350, 262141i, (262141i < _e350));
let _e836 = global_3.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e844 = (_e734 + 2i);
let _e846 = select(_e350, _e844, (_e844 < _e350));
let _e852 = global_3.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
let _e859 = (bitcast<f32>((((_e852 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e860 = (_e734 + 6i);
let _e862 = select(_e350, _e860, (_e860 < _e350));
let _e868 = global_3.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e876 = (_e734 + 1026i);
let _e878 = select(_e350, _e876, (_e876 < _e350));
let _e884 = global_3.member[bitcast<u32>(select(0i, _e878, (_e878 > 0i)))];
let _e891 = (bitcast<f32>((((_e884 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e892 = (_e734 + 1030i);
let _e894 = select(_e350, _e892, (_e892 < _e350));
let _e900 = global_3.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e910 = (_e859 + (((bitcast<f32>((((_e868 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e859) * _e738));
let _e918 = select(_e350, 2i, (2i < _e350));
let _e924 = global_3.member[bitcast<u32>(select(0i, _e918, (_e918 > 0i)))];
let _e933 = select(_e350, 262142i, (262142i < _e350));
let _e939 = global_3.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e947 = (_e734 + 3i);
let _e949 = select(_e350, _e947, (_e947 < _e350));
let _e955 = global_3.member[bitcast<u32>(select(0i, _e949, (_e949 > 0i)))];
let _e960 = (bitcast<f32>(((_e955 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e967 = (bitcast<f32>((((_e955 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e968 = (_e734 + 7i);
let _e970 = select(_e350, _e968, (_e968 < _e350));
let _e976 = global_3.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e989 = (_e734 + 1027i);
let _e991 = select(_e350, _e989, (_e989 < _e350));
let _e997 = global_3.member[bitcast<u32>(select(0i, _e991, (_e991 > 0i)))];
let _e1002 = (bitcast<f32>(((_e997 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e1009 = (bitcast<f32>((((_e997 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e1010 = (_e734 + 1031i);
let _e1012 = select(_e350, _e1010, (_e1010 < _e350));
let _e1018 = global_3.member[bitcast<u32>(select(0i, _e1012, (_e1012 > 0i)))];
let _e1033 = (_e960 + (((bitcast<f32>(((_e976 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e960) * _e738));
let _e1042 = (_e967 + (((bitcast<f32>((((_e976 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e967) * _e738));
let _e1050 = select(_e350, 3i, (3i < _e350));
let _e1056 = global_3.member[bitcast<u32>(select(0i, _e1050, (_e1050 > 0i)))];
let _e1070 = select(_e350, 262143i, (262143i < _e350));
let _e1076 = global_3.member[bitcast<u32>(select(0i, _e1070, (_e1070 > 0i)))];
let _e1103 = (((_e807 + (((_e788 + (((bitcast<f32>((((_e797 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e788) * _e738)) - _e807) * _e736)) * _e740) + (((bitcast<f32>((((_e821 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e727) + ((bitcast<f32>((((_e836 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e731)));
let _e1110 = -((_e1103 * 1f));
let _e1112 = select(-87f, _e1110, (_e1110 > -87f));
let _e1114 = select(88f, _e1112, (_e1112 < 88f));
let _e1116 = ((_e1114 * 1.442695f) + 0.5f);
let _e1118 = select(-127f, _e1116, (_e1116 > -127f));
let _e1120 = select(128f, _e1118, (_e1118 < 128f));
let _e1127 = select(0i, select(select(i32(_e1120), i32(-2147483648), (_e1120 < -2147483600f)), 2147483647i, (_e1120 > 2147483500f)), (_e1120 == _e1120));
let _e1131 = (_e1127 - select(0i, 1i, (_e1120 < f32(_e1127))));
let _e1132 = f32(_e1131);
let _e1136 = ((_e1114 - (_e1132 * 0.6933594f)) - (_e1132 * -2.1219444e-4f));
let _e1157 = (1f - ((1f + (_e1136 * (1f + (_e1136 * (0.5f + (_e1136 * (0.16666667f + (_e1136 * (0.041666668f + (_e1136 * (0.008333334f + (_e1136 * (0.001388889f + (_e1136 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1131 + 127i)) << bitcast<u32>(23i)))));
let _e1160 = (_e1157 / select(1e-12f, _e1103, (_e1103 > 1e-12f)));
global_2.member[_e130] = _e141;
global_2.member[_e142] = _e151;
global_2.member[_e153] = _e162;
global_2.member[_e164] = _e173;
global_2.member[_e175] = _e184;
global_2.member[_e186] = _e195;
global_2.member[_e197] = _e347;
global_2.member[_e208] = _e217;
global_2.member[_e219] = select((_e228 * _e1157), 0f, _e343);
global_2.member[((9u * _e128) + _e130)] = ((((_e910 + (((_e891 + (((bitcast<f32>((((_e900 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e891) * _e738)) - _e910) * _e736)) * _e740) + (((bitcast<f32>((((_e924 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e727) + ((bitcast<f32>((((_e939 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e731))) * _e1160);
global_2.member[((10u * _e128) + _e130)] = ((((_e1033 + (((_e1002 + (((bitcast<f32>(((_e1018 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e1002) * _e738)) - _e1033) * _e736)) * _e740) + (((bitcast<f32>(((_e1056 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e727) + ((bitcast<f32>(((_e1076 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e731))) * _e1160);
global_2.member[((11u * _e128) + _e130)] = ((((_e1042 + (((_e1009 + (((bitcast<f32>((((_e1018 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e1009) * _e738)) - _e1042) * _e736)) * _e740) + (((bitcast<f32>((((_e1056 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e727) + ((bitcast<f32>((((_e1076 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e731))) * _e1160);
global_2.member[((12u * _e128) + _e130)] = _e1157;
global_2.member[_e230] = _e239;
global_2.member[_e241] = _e250;
global_2.member[_e252] = _e261;
global_2.member[_e263] = _e272;
global_2.member[_e274] = _e283;
global_2.member[_e285] = _e294;
global_2.member[_e296] = _e305;
global_2.member[_e307] = _e316;
global_2.member[_e318] = _e327;
global_2.member[_e329] = _e338;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
