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
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
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
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_24 {
member: type_7,
member_1: u32,
}
struct type_25 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: type_23,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_24,
member_15: type_24,
member_16: type_24,
member_17: type_24,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_26 {
member: type_25,
}
struct type_28 {
member: f32,
member_1: f32,
}
struct type_31 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_26;
@group(0) @binding(3)
var<storage, read_write> global_2: type_31;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_749_: i32;
var phi_829_: i32;
var phi_909_: i32;
var phi_989_: i32;
var phi_1069_: i32;
var phi_1107_: bool;
var phi_2362_: i32;
var phi_2396_: type_28;
var phi_2423_: type_28;
var phi_2450_: type_28;
var phi_2477_: type_28;
var phi_2510_: i32;
var phi_2570_: i32;
var phi_2678_: i32;
var phi_2697_: u32;
var phi_2765_: u32;
var phi_2857_: u32;
var phi_2511_: i32;
var phi_2363_: i32;
var phi_3183_: i32;
var phi_3217_: type_28;
var phi_3244_: type_28;
var phi_3271_: type_28;
var phi_3298_: type_28;
var phi_3331_: i32;
var phi_3391_: i32;
var phi_3499_: i32;
var phi_3518_: u32;
var phi_3586_: u32;
var phi_3678_: u32;
var phi_3332_: i32;
var phi_3184_: i32;
var phi_3730_: vec2<f32>;
var phi_3731_: vec2<f32>;
var phi_3741_: vec2<f32>;
var phi_3772_: i32;
var phi_3855_: i32;
var phi_3870_: f32;
var phi_3876_: f32;
var phi_3932_: i32;
var phi_4040_: i32;
var phi_4059_: u32;
var phi_4127_: u32;
var phi_4219_: u32;
var phi_3856_: i32;
var phi_3773_: i32;
var phi_4328_: i32;
var phi_4343_: f32;
var phi_4349_: f32;
var phi_4405_: i32;
var phi_4513_: i32;
var phi_4532_: u32;
var phi_4600_: u32;
var phi_4692_: u32;
var phi_4329_: i32;
var phi_5017_: i32;
var phi_5051_: type_28;
var phi_5078_: type_28;
var phi_5105_: type_28;
var phi_5132_: type_28;
var phi_5165_: i32;
var phi_5225_: i32;
var phi_5333_: i32;
var phi_5352_: u32;
var phi_5420_: u32;
var phi_5512_: u32;
var phi_5166_: i32;
var phi_5018_: i32;
var phi_5564_: vec2<f32>;
var phi_5565_: vec2<f32>;
var phi_5575_: vec2<f32>;
var phi_5606_: i32;
var phi_5689_: i32;
var phi_5704_: f32;
var phi_5710_: f32;
var phi_5766_: i32;
var phi_5874_: i32;
var phi_5893_: u32;
var phi_5961_: u32;
var phi_6053_: u32;
var phi_5690_: i32;
var phi_5607_: i32;
var phi_6162_: i32;
var phi_6177_: f32;
var phi_6183_: f32;
var phi_6239_: i32;
var phi_6347_: i32;
var phi_6366_: u32;
var phi_6434_: u32;
var phi_6526_: u32;
var phi_6163_: i32;
let _e49 = global;
let _e55 = arrayLength((&global_4.member));
let _e58 = arrayLength((&global_2.member));
let _e61 = global_1.member.member_2;
let _e67 = (_e49.x + _e61.member);
let _e69 = (_e49.y + _e61.member_1);
if (_e67 < _e61.member_2) {
if (_e69 < _e61.member_3) {
let _e74 = global_1.member.member;
let _e80 = global_1.member.member_10.member_4.member;
let _e81 = (_e80 + 1u);
let _e86 = global_1.member.member_10.member_4.member_1;
let _e89 = bitcast<i32>((_e81 * (_e86 + 1u)));
let _e90 = (7i * _e89);
let _e91 = (_e69 * _e81);
let _e93 = bitcast<i32>((_e91 + _e67));
let _e94 = (_e90 + _e93);
let _e96 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e98 = select(_e96, _e94, (_e94 < _e96));
let _e104 = global_3.member[bitcast<u32>(select(0i, _e98, (_e98 > 0i)))];
let _e105 = (_e67 + 1u);
let _e107 = bitcast<i32>((_e91 + _e105));
let _e108 = (_e90 + _e107);
let _e110 = select(_e96, _e108, (_e108 < _e96));
let _e116 = global_3.member[bitcast<u32>(select(0i, _e110, (_e110 > 0i)))];
let _e119 = ((_e69 + 1u) * _e81);
let _e121 = bitcast<i32>((_e119 + _e67));
let _e122 = (_e90 + _e121);
let _e124 = select(_e96, _e122, (_e122 < _e96));
let _e130 = global_3.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e132 = bitcast<i32>((_e119 + _e105));
let _e133 = (_e90 + _e132);
let _e135 = select(_e96, _e133, (_e133 < _e96));
let _e141 = global_3.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
if (((_e104 + _e116) + (_e130 + _e141)) > 0f) {
let _e146 = select(_e96, _e93, (_e93 < _e96));
let _e152 = global_3.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e153 = (_e89 + _e93);
let _e155 = select(_e96, _e153, (_e153 < _e96));
let _e161 = global_3.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = select(_e96, _e107, (_e107 < _e96));
let _e169 = global_3.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e170 = (_e89 + _e107);
let _e172 = select(_e96, _e170, (_e170 < _e96));
let _e178 = global_3.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = select(_e96, _e121, (_e121 < _e96));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e187 = (_e89 + _e121);
let _e189 = select(_e96, _e187, (_e187 < _e96));
let _e195 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = select(_e96, _e132, (_e132 < _e96));
let _e203 = global_3.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e204 = (_e89 + _e132);
let _e206 = select(_e96, _e204, (_e204 < _e96));
let _e212 = global_3.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e214 = select(_e169, _e152, (_e152 < _e169));
let _e216 = select(_e203, _e186, (_e186 < _e203));
let _e218 = select(_e216, _e214, (_e214 < _e216));
let _e220 = select(_e178, _e161, (_e161 < _e178));
let _e222 = select(_e212, _e195, (_e195 < _e212));
let _e224 = select(_e222, _e220, (_e220 < _e222));
let _e226 = select(_e169, _e152, (_e152 > _e169));
let _e228 = select(_e203, _e186, (_e186 > _e203));
let _e230 = select(_e228, _e226, (_e226 > _e228));
let _e232 = select(_e178, _e161, (_e161 > _e178));
let _e234 = select(_e212, _e195, (_e195 > _e212));
let _e236 = select(_e234, _e232, (_e232 > _e234));
let _e237 = -(65536f);
let _e239 = select(_e237, _e218, (_e218 > _e237));
let _e241 = select(65536f, _e239, (_e239 < 65536f));
let _e248 = select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < -2147483600f)), 2147483647i, (_e241 > 2147483500f)), (_e241 == _e241));
let _e252 = (_e248 - select(0i, 1i, (_e241 < f32(_e248))));
let _e254 = select(_e237, _e230, (_e230 > _e237));
let _e256 = select(65536f, _e254, (_e254 < 65536f));
let _e263 = select(0i, select(select(i32(_e256), i32(-2147483648), (_e256 < -2147483600f)), 2147483647i, (_e256 > 2147483500f)), (_e256 == _e256));
let _e268 = ((_e263 - select(0i, 1i, (_e256 < f32(_e263)))) + 1i);
let _e270 = select(_e237, _e224, (_e224 > _e237));
let _e272 = select(65536f, _e270, (_e270 < 65536f));
let _e279 = select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < -2147483600f)), 2147483647i, (_e272 > 2147483500f)), (_e272 == _e272));
let _e283 = (_e279 - select(0i, 1i, (_e272 < f32(_e279))));
let _e285 = select(_e237, _e236, (_e236 > _e237));
let _e287 = select(65536f, _e285, (_e285 < 65536f));
let _e294 = select(0i, select(select(i32(_e287), i32(-2147483648), (_e287 < -2147483600f)), 2147483647i, (_e287 > 2147483500f)), (_e287 == _e287));
let _e299 = ((_e294 - select(0i, 1i, (_e287 < f32(_e294)))) + 1i);
if (((_e252 >> bitcast<u32>(3i)) == (_e268 >> bitcast<u32>(3i))) && ((_e283 >> bitcast<u32>(3i)) == (_e299 >> bitcast<u32>(3i)))) {
let _e319 = global_1.member.member_10.member_15;
let _e320 = bitcast<i32>(_e319);
let _e322 = (firstTrailingBit(8u) & 31u);
let _e324 = (_e252 >> bitcast<u32>(_e322));
let _e326 = (_e283 >> bitcast<u32>(_e322));
let _e331 = global_1.member.member_10.member_14.member;
let _e332 = bitcast<i32>(_e331);
let _e337 = global_1.member.member_10.member_14.member_1;
let _e338 = bitcast<i32>(_e337);
let _e343 = global_1.member.member_10.member_14.member_2;
if ((((((_e324 >= 0i) && (_e324 < _e332)) && (_e326 >= 0i)) && (_e326 < _e338)) && (_e320 >= 0i)) && (_e320 < bitcast<i32>(_e343))) {
phi_749_ = (((((_e320 * _e338) + _e326) * _e332) + _e324) * 3i);
} else {
phi_749_ = -1i;
}
let _e362 = phi_749_;
let _e363 = (_e362 + 2i);
let _e365 = (bitcast<i32>(_e55) - 1i);
let _e367 = select(_e365, _e363, (_e363 < _e365));
let _e373 = global_4.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e374 = bitcast<i32>(_e373);
phi_1107_ = (select(((((_e374 - 1i) * 64i) + ((_e283 & 7i) * 8i)) + (_e252 & 7i)), -1i, ((_e362 < 0i) || (_e374 == 0i))) >= 0i);
} else {
let _e391 = global_1.member.member_10.member_15;
let _e392 = bitcast<i32>(_e391);
let _e394 = (firstTrailingBit(8u) & 31u);
let _e396 = (_e252 >> bitcast<u32>(_e394));
let _e398 = (_e283 >> bitcast<u32>(_e394));
let _e403 = global_1.member.member_10.member_14.member;
let _e404 = bitcast<i32>(_e403);
let _e409 = global_1.member.member_10.member_14.member_1;
let _e410 = bitcast<i32>(_e409);
let _e415 = global_1.member.member_10.member_14.member_2;
let _e419 = ((_e396 >= 0i) && (_e396 < _e404));
let _e420 = (_e398 >= 0i);
let _e422 = (_e398 < _e410);
let _e424 = (_e392 >= 0i);
let _e426 = (_e392 < bitcast<i32>(_e415));
if ((((_e419 && _e420) && _e422) && _e424) && _e426) {
phi_829_ = (((((_e392 * _e410) + _e398) * _e404) + _e396) * 3i);
} else {
phi_829_ = -1i;
}
let _e434 = phi_829_;
let _e435 = (_e434 + 2i);
let _e437 = (bitcast<i32>(_e55) - 1i);
let _e439 = select(_e437, _e435, (_e435 < _e437));
let _e445 = global_4.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e446 = bitcast<i32>(_e445);
let _e450 = ((_e283 & 7i) * 8i);
let _e452 = (_e252 & 7i);
let _e461 = (_e268 >> bitcast<u32>(_e394));
let _e464 = ((_e461 >= 0i) && (_e461 < _e404));
if ((((_e464 && _e420) && _e422) && _e424) && _e426) {
phi_909_ = (((((_e392 * _e410) + _e398) * _e404) + _e461) * 3i);
} else {
phi_909_ = -1i;
}
let _e475 = phi_909_;
let _e476 = (_e475 + 2i);
let _e478 = select(_e437, _e476, (_e476 < _e437));
let _e484 = global_4.member[bitcast<u32>(select(0i, _e478, (_e478 > 0i)))];
let _e485 = bitcast<i32>(_e484);
let _e489 = (_e268 & 7i);
let _e498 = (_e299 >> bitcast<u32>(_e394));
let _e499 = (_e498 >= 0i);
let _e501 = (_e498 < _e410);
if ((((_e419 && _e499) && _e501) && _e424) && _e426) {
phi_989_ = (((((_e392 * _e410) + _e498) * _e404) + _e396) * 3i);
} else {
phi_989_ = -1i;
}
let _e511 = phi_989_;
let _e512 = (_e511 + 2i);
let _e514 = select(_e437, _e512, (_e512 < _e437));
let _e520 = global_4.member[bitcast<u32>(select(0i, _e514, (_e514 > 0i)))];
let _e521 = bitcast<i32>(_e520);
let _e525 = ((_e299 & 7i) * 8i);
if ((((_e464 && _e499) && _e501) && _e424) && _e426) {
phi_1069_ = (((((_e392 * _e410) + _e498) * _e404) + _e461) * 3i);
} else {
phi_1069_ = -1i;
}
let _e544 = phi_1069_;
let _e545 = (_e544 + 2i);
let _e547 = select(_e437, _e545, (_e545 < _e437));
let _e553 = global_4.member[bitcast<u32>(select(0i, _e547, (_e547 > 0i)))];
let _e554 = bitcast<i32>(_e553);
phi_1107_ = ((((!((((_e268 - _e252) <= 8i) && ((_e299 - _e283) <= 8i))) || (select(((((_e446 - 1i) * 64i) + _e450) + _e452), -1i, ((_e434 < 0i) || (_e446 == 0i))) >= 0i)) || (select(((((_e485 - 1i) * 64i) + _e450) + _e489), -1i, ((_e475 < 0i) || (_e485 == 0i))) >= 0i)) || (select(((((_e521 - 1i) * 64i) + _e525) + _e452), -1i, ((_e511 < 0i) || (_e521 == 0i))) >= 0i)) || (select(((((_e554 - 1i) * 64i) + _e525) + _e489), -1i, ((_e544 < 0i) || (_e554 == 0i))) >= 0i));
}
let _e566 = phi_1107_;
if _e566 {
local_6 = _e89;
local_7 = _e93;
let _e567 = local_7;
let _e569 = select(_e96, _e567, (_e567 < _e96));
let _e574 = global_3.member[bitcast<u32>(select(0i, _e569, (_e569 > 0i)))];
let _e575 = local_6;
let _e576 = local_7;
let _e577 = (_e575 + _e576);
let _e579 = select(_e96, _e577, (_e577 < _e96));
let _e584 = global_3.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e585 = local_6;
let _e587 = local_7;
let _e588 = ((2i * _e585) + _e587);
let _e590 = select(_e96, _e588, (_e588 < _e96));
let _e595 = global_3.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e596 = local_6;
let _e598 = local_7;
let _e599 = ((3i * _e596) + _e598);
let _e601 = select(_e96, _e599, (_e599 < _e96));
let _e606 = global_3.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e607 = local_6;
let _e609 = local_7;
let _e610 = ((4i * _e607) + _e609);
let _e612 = select(_e96, _e610, (_e610 < _e96));
let _e617 = global_3.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e618 = local_6;
let _e620 = local_7;
let _e621 = ((5i * _e618) + _e620);
let _e623 = select(_e96, _e621, (_e621 < _e96));
let _e628 = global_3.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e629 = local_6;
let _e631 = local_7;
let _e632 = ((6i * _e629) + _e631);
let _e634 = select(_e96, _e632, (_e632 < _e96));
let _e639 = global_3.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e640 = local_6;
let _e642 = local_7;
let _e643 = ((7i * _e640) + _e642);
let _e645 = select(_e96, _e643, (_e643 < _e96));
let _e650 = global_3.member[bitcast<u32>(select(0i, _e645, (_e645 > 0i)))];
local_4 = _e89;
local_5 = _e107;
let _e651 = local_5;
let _e653 = select(_e96, _e651, (_e651 < _e96));
let _e658 = global_3.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e659 = local_4;
let _e660 = local_5;
let _e661 = (_e659 + _e660);
let _e663 = select(_e96, _e661, (_e661 < _e96));
let _e668 = global_3.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e669 = local_4;
let _e671 = local_5;
let _e672 = ((2i * _e669) + _e671);
let _e674 = select(_e96, _e672, (_e672 < _e96));
let _e679 = global_3.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e680 = local_4;
let _e682 = local_5;
let _e683 = ((3i * _e680) + _e682);
let _e685 = select(_e96, _e683, (_e683 < _e96));
let _e690 = global_3.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
let _e691 = local_4;
let _e693 = local_5;
let _e694 = ((4i * _e691) + _e693);
let _e696 = select(_e96, _e694, (_e694 < _e96));
let _e701 = global_3.member[bitcast<u32>(select(0i, _e696, (_e696 > 0i)))];
let _e702 = local_4;
let _e704 = local_5;
let _e705 = ((5i * _e702) + _e704);
let _e707 = select(_e96, _e705, (_e705 < _e96));
let _e712 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e713 = local_4;
let _e715 = local_5;
let _e716 = ((6i * _e713) + _e715);
let _e718 = select(_e96, _e716, (_e716 < _e96));
let _e723 = global_3.member[bitcast<u32>(select(0i, _e718, (_e718 > 0i)))];
let _e724 = local_4;
let _e726 = local_5;
let _e727 = ((7i * _e724) + _e726);
let _e729 = select(_e96, _e727, (_e727 < _e96));
let _e734 = global_3.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
local_2 = _e89;
local_3 = _e121;
let _e735 = local_3;
let _e737 = select(_e96, _e735, (_e735 < _e96));
let _e742 = global_3.member[bitcast<u32>(select(0i, _e737, (_e737 > 0i)))];
let _e743 = local_2;
let _e744 = local_3;
let _e745 = (_e743 + _e744);
let _e747 = select(_e96, _e745, (_e745 < _e96));
let _e752 = global_3.member[bitcast<u32>(select(0i, _e747, (_e747 > 0i)))];
let _e753 = local_2;
let _e755 = local_3;
let _e756 = ((2i * _e753) + _e755);
let _e758 = select(_e96, _e756, (_e756 < _e96));
let _e763 = global_3.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e764 = local_2;
let _e766 = local_3;
let _e767 = ((3i * _e764) + _e766);
let _e769 = select(_e96, _e767, (_e767 < _e96));
let _e774 = global_3.member[bitcast<u32>(select(0i, _e769, (_e769 > 0i)))];
let _e775 = local_2;
let _e777 = local_3;
let _e778 = ((4i * _e775) + _e777);
let _e780 = select(_e96, _e778, (_e778 < _e96));
let _e785 = global_3.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
let _e786 = local_2;
let _e788 = local_3;
let _e789 = ((5i * _e786) + _e788);
let _e791 = select(_e96, _e789, (_e789 < _e96));
let _e796 = global_3.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e797 = local_2;
let _e799 = local_3;
let _e800 = ((6i * _e797) + _e799);
let _e802 = select(_e96, _e800, (_e800 < _e96));
let _e807 = global_3.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e808 = local_2;
let _e810 = local_3;
let _e811 = ((7i * _e808) + _e810);
let _e813 = select(_e96, _e811, (_e811 < _e96));
let _e818 = global_3.member[bitcast<u32>(select(0i, _e813, (_e813 > 0i)))];
local = _e89;
local_1 = _e132;
let _e819 = local_1;
let _e821 = select(_e96, _e819, (_e819 < _e96));
let _e826 = global_3.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e827 = local;
let _e828 = local_1;
let _e829 = (_e827 + _e828);
let _e831 = select(_e96, _e829, (_e829 < _e96));
let _e836 = global_3.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e837 = local;
let _e839 = local_1;
let _e840 = ((2i * _e837) + _e839);
let _e842 = select(_e96, _e840, (_e840 < _e96));
let _e847 = global_3.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e848 = local;
let _e850 = local_1;
let _e851 = ((3i * _e848) + _e850);
let _e853 = select(_e96, _e851, (_e851 < _e96));
let _e858 = global_3.member[bitcast<u32>(select(0i, _e853, (_e853 > 0i)))];
let _e859 = local;
let _e861 = local_1;
let _e862 = ((4i * _e859) + _e861);
let _e864 = select(_e96, _e862, (_e862 < _e96));
let _e869 = global_3.member[bitcast<u32>(select(0i, _e864, (_e864 > 0i)))];
let _e870 = local;
let _e872 = local_1;
let _e873 = ((5i * _e870) + _e872);
let _e875 = select(_e96, _e873, (_e873 < _e96));
let _e880 = global_3.member[bitcast<u32>(select(0i, _e875, (_e875 > 0i)))];
let _e881 = local;
let _e883 = local_1;
let _e884 = ((6i * _e881) + _e883);
let _e886 = select(_e96, _e884, (_e884 < _e96));
let _e891 = global_3.member[bitcast<u32>(select(0i, _e886, (_e886 > 0i)))];
let _e892 = local;
let _e894 = local_1;
let _e895 = ((7i * _e892) + _e894);
let _e897 = select(_e96, _e895, (_e895 < _e96));
let _e902 = global_3.member[bitcast<u32>(select(0i, _e897, (_e897 > 0i)))];
let _e909 = ((_e595 + _e679) + (_e763 + _e847));
let _e910 = ((_e606 + _e690) + (_e774 + _e858));
let _e911 = ((_e617 + _e701) + (_e785 + _e869));
let _e913 = select(_e910, _e909, (_e909 > _e910));
let _e917 = (_e230 - _e218);
let _e918 = (_e236 - _e224);
let _e923 = (f32(bitcast<i32>(_e67)) - 0.5f);
let _e926 = (f32(bitcast<i32>(_e69)) - 0.5f);
let _e940 = (_e923 + 1f);
let _e955 = (_e926 + 1f);
let _e984 = (_e826 - _e574);
let _e985 = (_e836 - _e584);
let _e986 = (_e742 - _e658);
let _e987 = (_e752 - _e668);
let _e994 = (0.5f * bitcast<f32>((bitcast<u32>(((_e984 * _e987) - (_e985 * _e986))) & 2147483647u)));
if ((select(_e911, _e913, (_e913 > _e911)) <= 0f) || (((((((bitcast<f32>((bitcast<u32>((_e574 - _e923)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e584 - _e926)) & 2147483647u)) < 0.5f)) && (_e650 != 2f)) && (((bitcast<f32>((bitcast<u32>((_e658 - _e940)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e668 - _e926)) & 2147483647u)) < 0.5f)) && (_e734 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e742 - _e923)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e752 - _e955)) & 2147483647u)) < 0.5f)) && (_e818 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e826 - _e940)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e836 - _e955)) & 2147483647u)) < 0.5f)) && (_e902 != 2f))) && (_e994 >= 0.5f))) {
} else {
let _e998 = (_e574 - _e742);
let _e1001 = (_e584 - _e752);
let _e1004 = ((_e998 * (_e668 - _e752)) - (_e1001 * (_e658 - _e742)));
let _e1005 = (_e658 - _e574);
let _e1007 = (_e668 - _e584);
let _e1009 = ((_e1005 * _e985) - (_e1007 * _e984));
let _e1014 = (((_e826 - _e658) * _e987) - ((_e836 - _e668) * _e986));
let _e1015 = (_e742 - _e826);
let _e1018 = (_e752 - _e836);
let _e1021 = ((_e1015 * (_e584 - _e836)) - (_e1018 * (_e574 - _e826)));
let _e1037 = (_e650 == 2f);
let _e1038 = (_e734 == 2f);
let _e1040 = (_e818 == 2f);
let _e1042 = (_e902 == 2f);
if ((((((((_e1004 > 0f) && (_e1009 > 0f)) && (_e1021 > 0f)) && (_e1014 > 0f)) || ((((_e1004 < 0f) && (_e1009 < 0f)) && (_e1021 < 0f)) && (_e1014 < 0f))) && !((((_e1037 || _e1038) || _e1040) || _e1042))) && (_e994 >= (2f * 0.25f))) && (select(_e918, _e917, (_e917 > _e918)) <= 64f)) {
let _e1056 = (1f / 3f);
let _e1057 = (((_e595 + _e606) + _e617) * _e1056);
let _e1062 = (((_e679 + _e690) + _e701) * _e1056);
let _e1069 = (((_e763 + _e774) + _e785) * _e1056);
let _e1074 = (((_e847 + _e858) + _e869) * _e1056);
let _e1085 = select(_e195, _e212, (_e212 < _e195));
let _e1087 = select(_e1085, _e220, (_e220 < _e1085));
let _e1089 = select(_e195, _e212, (_e212 > _e195));
let _e1091 = select(_e1089, _e232, (_e232 > _e1089));
let _e1093 = select(_e237, _e1087, (_e1087 > _e237));
let _e1095 = select(65536f, _e1093, (_e1093 < 65536f));
let _e1102 = select(0i, select(select(i32(_e1095), i32(-2147483648), (_e1095 < -2147483600f)), 2147483647i, (_e1095 > 2147483500f)), (_e1095 == _e1095));
let _e1109 = select(_e237, _e1091, (_e1091 > _e237));
let _e1111 = select(65536f, _e1109, (_e1109 < 65536f));
let _e1118 = select(0i, select(select(i32(_e1111), i32(-2147483648), (_e1111 < -2147483600f)), 2147483647i, (_e1111 > 2147483500f)), (_e1111 == _e1111));
phi_2362_ = ((_e1102 - select(0i, 1i, (_e1095 < f32(_e1102)))) + 1i);
loop {
let _e1124 = phi_2362_;
let _e1125 = (_e1124 <= (_e1118 - select(0i, 1i, (_e1111 < f32(_e1118)))));
if _e1125 {
let _e1126 = f32(_e1124);
let _e1127 = (_e161 <= _e1126);
let _e1128 = (_e178 <= _e1126);
if (_e1127 != _e1128) {
let _e1135 = (_e152 + ((_e1126 - _e161) * ((_e169 - _e152) / (_e178 - _e161))));
phi_2396_ = type_28(select(_e1135, 65536f, (65536f < _e1135)), select(_e1135, _e237, (_e237 > _e1135)));
} else {
phi_2396_ = type_28(65536f, _e237);
}
let _e1143 = phi_2396_;
let _e1146 = (_e212 <= _e1126);
if (_e1128 != _e1146) {
let _e1153 = (_e169 + ((_e1126 - _e178) * ((_e203 - _e169) / (_e212 - _e178))));
phi_2423_ = type_28(select(_e1153, _e1143.member, (_e1143.member < _e1153)), select(_e1153, _e1143.member_1, (_e1143.member_1 > _e1153)));
} else {
phi_2423_ = _e1143;
}
let _e1160 = phi_2423_;
let _e1163 = (_e195 <= _e1126);
if (_e1146 != _e1163) {
let _e1170 = (_e203 + ((_e1126 - _e212) * ((_e186 - _e203) / (_e195 - _e212))));
phi_2450_ = type_28(select(_e1170, _e1160.member, (_e1160.member < _e1170)), select(_e1170, _e1160.member_1, (_e1160.member_1 > _e1170)));
} else {
phi_2450_ = _e1160;
}
let _e1177 = phi_2450_;
if (_e1163 != _e1127) {
let _e1186 = (_e186 + ((_e1126 - _e195) * ((_e152 - _e186) / (_e161 - _e195))));
phi_2477_ = type_28(select(_e1186, _e1177.member, (_e1177.member < _e1186)), select(_e1186, _e1177.member_1, (_e1177.member_1 > _e1186)));
} else {
phi_2477_ = _e1177;
}
let _e1193 = phi_2477_;
let _e1196 = -(_e1193.member);
let _e1198 = select(_e237, _e1196, (_e1196 > _e237));
let _e1200 = select(65536f, _e1198, (_e1198 < 65536f));
let _e1207 = select(0i, select(select(i32(_e1200), i32(-2147483648), (_e1200 < -2147483600f)), 2147483647i, (_e1200 > 2147483500f)), (_e1200 == _e1200));
phi_2510_ = -((_e1207 - select(0i, 1i, (_e1200 < f32(_e1207)))));
loop {
let _e1214 = phi_2510_;
let _e1216 = (f32(_e1214) < _e1193.member_1);
if _e1216 {
let _e1220 = global_1.member.member_10.member_15;
let _e1221 = bitcast<i32>(_e1220);
let _e1223 = (firstTrailingBit(8u) & 31u);
let _e1225 = (_e1214 >> bitcast<u32>(_e1223));
let _e1227 = (_e1124 >> bitcast<u32>(_e1223));
let _e1232 = global_1.member.member_10.member_14.member;
let _e1233 = bitcast<i32>(_e1232);
let _e1238 = global_1.member.member_10.member_14.member_1;
let _e1239 = bitcast<i32>(_e1238);
let _e1244 = global_1.member.member_10.member_14.member_2;
if ((((((_e1225 >= 0i) && (_e1225 < _e1233)) && (_e1227 >= 0i)) && (_e1227 < _e1239)) && (_e1221 >= 0i)) && (_e1221 < bitcast<i32>(_e1244))) {
phi_2570_ = (((((_e1221 * _e1239) + _e1227) * _e1233) + _e1225) * 3i);
} else {
phi_2570_ = -1i;
}
let _e1263 = phi_2570_;
let _e1264 = (_e1263 + 2i);
let _e1266 = (bitcast<i32>(_e55) - 1i);
let _e1268 = select(_e1266, _e1264, (_e1264 < _e1266));
let _e1273 = global_4.member[bitcast<u32>(select(0i, _e1268, (_e1268 > 0i)))];
let _e1274 = bitcast<i32>(_e1273);
let _e1285 = select(((((_e1274 - 1i) * 64i) + ((_e1124 & 7i) * 8i)) + (_e1214 & 7i)), -1i, ((_e1263 < 0i) || (_e1274 == 0i)));
let _e1289 = global_1.member.member_10.member_20;
let _e1290 = (_e1289 * (1f / _e994));
if ((_e1285 >= 0i) && (_e1290 > 0f)) {
let _e1294 = (_e1285 * 6i);
let _e1296 = (((_e909 * 0.25f) * _e1290) + 0.5f);
let _e1298 = select(-1073741800f, _e1296, (_e1296 > -1073741800f));
let _e1300 = select(1073741800f, _e1298, (_e1298 < 1073741800f));
let _e1307 = select(0i, select(select(i32(_e1300), i32(-2147483648), (_e1300 < -2147483600f)), 2147483647i, (_e1300 > 2147483500f)), (_e1300 == _e1300));
let _e1311 = (_e1307 - select(0i, 1i, (_e1300 < f32(_e1307))));
let _e1316 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e1316 {
phi_2678_ = 0i;
} else {
let _e1318 = (((_e910 * 0.25f) * _e1290) + 0.5f);
let _e1320 = select(-1073741800f, _e1318, (_e1318 > -1073741800f));
let _e1322 = select(1073741800f, _e1320, (_e1320 < 1073741800f));
let _e1329 = select(0i, select(select(i32(_e1322), i32(-2147483648), (_e1322 < -2147483600f)), 2147483647i, (_e1322 > 2147483500f)), (_e1322 == _e1322));
phi_2678_ = (_e1329 - select(0i, 1i, (_e1322 < f32(_e1329))));
}
let _e1335 = phi_2678_;
let _e1336 = bitcast<u32>(_e1311);
let _e1340 = bitcast<u32>((_e1335 + (_e1311 >> bitcast<u32>(31i))));
if ((_e1336 | _e1340) == 0u) {
} else {
let _e1343 = bitcast<u32>(_e1294);
if (_e1343 < _e58) {
let _e1346 = atomicAdd((&global_2.member[_e1343]), _e1336);
phi_2697_ = _e1346;
} else {
phi_2697_ = 0u;
}
let _e1348 = phi_2697_;
let _e1352 = (_e1340 + select(0u, 1u, ((_e1348 + _e1336) < _e1336)));
if (_e1352 == 0u) {
} else {
let _e1354 = (_e1343 + 1u);
if (_e1354 < _e58) {
let _e1357 = atomicAdd((&global_2.member[_e1354]), _e1352);
}
}
}
if _e1316 {
} else {
let _e1360 = (((_e911 * 0.25f) * _e1290) + 0.5f);
let _e1362 = select(-1073741800f, _e1360, (_e1360 > -1073741800f));
let _e1364 = select(1073741800f, _e1362, (_e1362 < 1073741800f));
let _e1371 = select(0i, select(select(i32(_e1364), i32(-2147483648), (_e1364 < -2147483600f)), 2147483647i, (_e1364 > 2147483500f)), (_e1364 == _e1364));
let _e1375 = (_e1371 - select(0i, 1i, (_e1364 < f32(_e1371))));
let _e1376 = bitcast<u32>(_e1375);
let _e1379 = bitcast<u32>((_e1375 >> bitcast<u32>(31i)));
if ((_e1376 | _e1379) == 0u) {
} else {
let _e1382 = bitcast<u32>((_e1294 + 4i));
if (_e1382 < _e58) {
let _e1385 = atomicAdd((&global_2.member[_e1382]), _e1376);
phi_2765_ = _e1385;
} else {
phi_2765_ = 0u;
}
let _e1387 = phi_2765_;
let _e1391 = (_e1379 + select(0u, 1u, ((_e1387 + _e1376) < _e1376)));
if (_e1391 == 0u) {
} else {
let _e1393 = (_e1382 + 1u);
if (_e1393 < _e58) {
let _e1396 = atomicAdd((&global_2.member[_e1393]), _e1391);
}
}
}
}
let _e1399 = global_1.member.member_20;
if (_e1399 > 0f) {
let _e1402 = ((((((_e628 * _e1057) + (_e712 * _e1062)) + ((_e796 * _e1069) + (_e880 * _e1074))) * 0.25f) * _e1290) + 0.5f);
let _e1404 = select(-1073741800f, _e1402, (_e1402 > -1073741800f));
let _e1406 = select(1073741800f, _e1404, (_e1404 < 1073741800f));
let _e1413 = select(0i, select(select(i32(_e1406), i32(-2147483648), (_e1406 < -2147483600f)), 2147483647i, (_e1406 > 2147483500f)), (_e1406 == _e1406));
let _e1417 = (_e1413 - select(0i, 1i, (_e1406 < f32(_e1413))));
let _e1419 = ((((((_e639 * _e1057) + (_e723 * _e1062)) + ((_e807 * _e1069) + (_e891 * _e1074))) * 0.25f) * _e1290) + 0.5f);
let _e1421 = select(-1073741800f, _e1419, (_e1419 > -1073741800f));
let _e1423 = select(1073741800f, _e1421, (_e1421 < 1073741800f));
let _e1430 = select(0i, select(select(i32(_e1423), i32(-2147483648), (_e1423 < -2147483600f)), 2147483647i, (_e1423 > 2147483500f)), (_e1423 == _e1423));
let _e1436 = bitcast<u32>(_e1417);
let _e1440 = bitcast<u32>(((_e1430 - select(0i, 1i, (_e1423 < f32(_e1430)))) + (_e1417 >> bitcast<u32>(31i))));
if ((_e1436 | _e1440) == 0u) {
} else {
let _e1443 = bitcast<u32>((_e1294 + 2i));
if (_e1443 < _e58) {
let _e1446 = atomicAdd((&global_2.member[_e1443]), _e1436);
phi_2857_ = _e1446;
} else {
phi_2857_ = 0u;
}
let _e1448 = phi_2857_;
let _e1452 = (_e1440 + select(0u, 1u, ((_e1448 + _e1436) < _e1436)));
if (_e1452 == 0u) {
} else {
let _e1454 = (_e1443 + 1u);
if (_e1454 < _e58) {
let _e1457 = atomicAdd((&global_2.member[_e1454]), _e1452);
}
}
}
}
}
phi_2511_ = (_e1214 + 1i);
} else {
phi_2511_ = i32();
}
let _e1460 = phi_2511_;
continue;
continuing {
phi_2510_ = _e1460;
break if !(_e1216);
}
}
phi_2363_ = (_e1124 + 1i);
} else {
phi_2363_ = i32();
}
let _e1464 = phi_2363_;
continue;
continuing {
phi_2362_ = _e1464;
break if !(_e1125);
}
}
} else {
let _e1466 = select(1f, 0f, _e1037);
let _e1467 = select(1f, 0f, _e1038);
let _e1468 = select(1f, 0f, _e1040);
let _e1470 = ((_e1466 + _e1467) + _e1468);
let _e1474 = (_e679 * _e1467);
let _e1475 = (_e690 * _e1467);
let _e1476 = (_e701 * _e1467);
let _e1480 = (_e763 * _e1468);
let _e1481 = (_e774 * _e1468);
let _e1482 = (_e785 * _e1468);
let _e1488 = (1f / 3f);
let _e1489 = (((_e595 + _e606) + _e617) * _e1488);
let _e1496 = (((_e679 + _e690) + _e701) * _e1488);
let _e1499 = ((_e712 * _e1496) * _e1467);
let _e1500 = ((_e723 * _e1496) * _e1467);
let _e1505 = (((_e763 + _e774) + _e785) * _e1488);
let _e1508 = ((_e796 * _e1505) * _e1468);
let _e1509 = ((_e807 * _e1505) * _e1468);
let _e1512 = (1f / 6f);
let _e1513 = ((((_e595 * _e1466) + _e1474) + _e1480) * _e1512);
let _e1514 = ((((_e606 * _e1466) + _e1475) + _e1481) * _e1512);
let _e1515 = ((((_e617 * _e1466) + _e1476) + _e1482) * _e1512);
let _e1516 = (((((_e628 * _e1489) * _e1466) + _e1499) + _e1508) * _e1512);
let _e1517 = (((((_e639 * _e1489) * _e1466) + _e1500) + _e1509) * _e1512);
let _e1519 = select(_e658, _e574, (_e574 < _e658));
let _e1523 = select(_e668, _e584, (_e584 < _e668));
let _e1525 = select(_e752, _e1523, (_e1523 < _e752));
let _e1527 = select(_e658, _e574, (_e574 > _e658));
let _e1531 = select(_e668, _e584, (_e584 > _e668));
let _e1533 = select(_e752, _e1531, (_e1531 > _e752));
let _e1534 = (select(_e742, _e1527, (_e1527 > _e742)) - select(_e742, _e1519, (_e1519 < _e742)));
let _e1535 = (_e1533 - _e1525);
let _e1537 = select(_e1535, _e1534, (_e1534 > _e1535));
let _e1538 = (_e742 - _e574);
let _e1539 = (_e752 - _e584);
let _e1546 = (0.5f * bitcast<f32>((bitcast<u32>(((_e1005 * _e1539) - (_e1007 * _e1538))) & 2147483647u)));
let _e1547 = (_e1470 == 3f);
let _e1550 = (_e1537 <= 64f);
if ((_e1547 && (_e1546 >= 0.25f)) && _e1550) {
let _e1554 = select(_e237, _e1525, (_e1525 > _e237));
let _e1556 = select(65536f, _e1554, (_e1554 < 65536f));
let _e1563 = select(0i, select(select(i32(_e1556), i32(-2147483648), (_e1556 < -2147483600f)), 2147483647i, (_e1556 > 2147483500f)), (_e1556 == _e1556));
let _e1570 = select(_e237, _e1533, (_e1533 > _e237));
let _e1572 = select(65536f, _e1570, (_e1570 < 65536f));
let _e1579 = select(0i, select(select(i32(_e1572), i32(-2147483648), (_e1572 < -2147483600f)), 2147483647i, (_e1572 > 2147483500f)), (_e1572 == _e1572));
phi_3183_ = ((_e1563 - select(0i, 1i, (_e1556 < f32(_e1563)))) + 1i);
loop {
let _e1585 = phi_3183_;
let _e1586 = (_e1585 <= (_e1579 - select(0i, 1i, (_e1572 < f32(_e1579)))));
if _e1586 {
let _e1587 = f32(_e1585);
let _e1588 = (_e584 <= _e1587);
let _e1589 = (_e668 <= _e1587);
if (_e1588 != _e1589) {
let _e1594 = (_e574 + ((_e1587 - _e584) * (_e1005 / _e1007)));
phi_3217_ = type_28(select(_e1594, 65536f, (65536f < _e1594)), select(_e1594, _e237, (_e237 > _e1594)));
} else {
phi_3217_ = type_28(65536f, _e237);
}
let _e1602 = phi_3217_;
let _e1605 = (_e752 <= _e1587);
if (_e1589 != _e1605) {
let _e1610 = (_e658 + ((_e1587 - _e668) * (_e986 / _e987)));
phi_3244_ = type_28(select(_e1610, _e1602.member, (_e1602.member < _e1610)), select(_e1610, _e1602.member_1, (_e1602.member_1 > _e1610)));
} else {
phi_3244_ = _e1602;
}
let _e1617 = phi_3244_;
if (_e1605 != _e1605) {
let _e1626 = (_e742 + ((_e1587 - _e752) * ((_e742 - _e742) / (_e752 - _e752))));
phi_3271_ = type_28(select(_e1626, _e1617.member, (_e1617.member < _e1626)), select(_e1626, _e1617.member_1, (_e1617.member_1 > _e1626)));
} else {
phi_3271_ = _e1617;
}
let _e1633 = phi_3271_;
if (_e1605 != _e1588) {
let _e1640 = (_e742 + ((_e1587 - _e752) * (_e998 / _e1001)));
phi_3298_ = type_28(select(_e1640, _e1633.member, (_e1633.member < _e1640)), select(_e1640, _e1633.member_1, (_e1633.member_1 > _e1640)));
} else {
phi_3298_ = _e1633;
}
let _e1647 = phi_3298_;
let _e1650 = -(_e1647.member);
let _e1652 = select(_e237, _e1650, (_e1650 > _e237));
let _e1654 = select(65536f, _e1652, (_e1652 < 65536f));
let _e1661 = select(0i, select(select(i32(_e1654), i32(-2147483648), (_e1654 < -2147483600f)), 2147483647i, (_e1654 > 2147483500f)), (_e1654 == _e1654));
phi_3331_ = -((_e1661 - select(0i, 1i, (_e1654 < f32(_e1661)))));
loop {
let _e1668 = phi_3331_;
let _e1670 = (f32(_e1668) < _e1647.member_1);
if _e1670 {
let _e1674 = global_1.member.member_10.member_15;
let _e1675 = bitcast<i32>(_e1674);
let _e1677 = (firstTrailingBit(8u) & 31u);
let _e1679 = (_e1668 >> bitcast<u32>(_e1677));
let _e1681 = (_e1585 >> bitcast<u32>(_e1677));
let _e1686 = global_1.member.member_10.member_14.member;
let _e1687 = bitcast<i32>(_e1686);
let _e1692 = global_1.member.member_10.member_14.member_1;
let _e1693 = bitcast<i32>(_e1692);
let _e1698 = global_1.member.member_10.member_14.member_2;
if ((((((_e1679 >= 0i) && (_e1679 < _e1687)) && (_e1681 >= 0i)) && (_e1681 < _e1693)) && (_e1675 >= 0i)) && (_e1675 < bitcast<i32>(_e1698))) {
phi_3391_ = (((((_e1675 * _e1693) + _e1681) * _e1687) + _e1679) * 3i);
} else {
phi_3391_ = -1i;
}
let _e1717 = phi_3391_;
let _e1718 = (_e1717 + 2i);
let _e1720 = (bitcast<i32>(_e55) - 1i);
let _e1722 = select(_e1720, _e1718, (_e1718 < _e1720));
let _e1727 = global_4.member[bitcast<u32>(select(0i, _e1722, (_e1722 > 0i)))];
let _e1728 = bitcast<i32>(_e1727);
let _e1739 = select(((((_e1728 - 1i) * 64i) + ((_e1585 & 7i) * 8i)) + (_e1668 & 7i)), -1i, ((_e1717 < 0i) || (_e1728 == 0i)));
let _e1743 = global_1.member.member_10.member_20;
let _e1744 = (_e1743 * (1f / _e1546));
if ((_e1739 >= 0i) && (_e1744 > 0f)) {
let _e1748 = (_e1739 * 6i);
let _e1750 = ((_e1513 * _e1744) + 0.5f);
let _e1752 = select(-1073741800f, _e1750, (_e1750 > -1073741800f));
let _e1754 = select(1073741800f, _e1752, (_e1752 < 1073741800f));
let _e1761 = select(0i, select(select(i32(_e1754), i32(-2147483648), (_e1754 < -2147483600f)), 2147483647i, (_e1754 > 2147483500f)), (_e1754 == _e1754));
let _e1765 = (_e1761 - select(0i, 1i, (_e1754 < f32(_e1761))));
let _e1770 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e1770 {
phi_3499_ = 0i;
} else {
let _e1772 = ((_e1514 * _e1744) + 0.5f);
let _e1774 = select(-1073741800f, _e1772, (_e1772 > -1073741800f));
let _e1776 = select(1073741800f, _e1774, (_e1774 < 1073741800f));
let _e1783 = select(0i, select(select(i32(_e1776), i32(-2147483648), (_e1776 < -2147483600f)), 2147483647i, (_e1776 > 2147483500f)), (_e1776 == _e1776));
phi_3499_ = (_e1783 - select(0i, 1i, (_e1776 < f32(_e1783))));
}
let _e1789 = phi_3499_;
let _e1790 = bitcast<u32>(_e1765);
let _e1794 = bitcast<u32>((_e1789 + (_e1765 >> bitcast<u32>(31i))));
if ((_e1790 | _e1794) == 0u) {
} else {
let _e1797 = bitcast<u32>(_e1748);
if (_e1797 < _e58) {
let _e1800 = atomicAdd((&global_2.member[_e1797]), _e1790);
phi_3518_ = _e1800;
} else {
phi_3518_ = 0u;
}
let _e1802 = phi_3518_;
let _e1806 = (_e1794 + select(0u, 1u, ((_e1802 + _e1790) < _e1790)));
if (_e1806 == 0u) {
} else {
let _e1808 = (_e1797 + 1u);
if (_e1808 < _e58) {
let _e1811 = atomicAdd((&global_2.member[_e1808]), _e1806);
}
}
}
if _e1770 {
} else {
let _e1814 = ((_e1515 * _e1744) + 0.5f);
let _e1816 = select(-1073741800f, _e1814, (_e1814 > -1073741800f));
let _e1818 = select(1073741800f, _e1816, (_e1816 < 1073741800f));
let _e1825 = select(0i, select(select(i32(_e1818), i32(-2147483648), (_e1818 < -2147483600f)), 2147483647i, (_e1818 > 2147483500f)), (_e1818 == _e1818));
let _e1829 = (_e1825 - select(0i, 1i, (_e1818 < f32(_e1825))));
let _e1830 = bitcast<u32>(_e1829);
let _e1833 = bitcast<u32>((_e1829 >> bitcast<u32>(31i)));
if ((_e1830 | _e1833) == 0u) {
} else {
let _e1836 = bitcast<u32>((_e1748 + 4i));
if (_e1836 < _e58) {
let _e1839 = atomicAdd((&global_2.member[_e1836]), _e1830);
phi_3586_ = _e1839;
} else {
phi_3586_ = 0u;
}
let _e1841 = phi_3586_;
let _e1845 = (_e1833 + select(0u, 1u, ((_e1841 + _e1830) < _e1830)));
if (_e1845 == 0u) {
} else {
let _e1847 = (_e1836 + 1u);
if (_e1847 < _e58) {
let _e1850 = atomicAdd((&global_2.member[_e1847]), _e1845);
}
}
}
}
let _e1853 = global_1.member.member_20;
if (_e1853 > 0f) {
let _e1856 = ((_e1516 * _e1744) + 0.5f);
let _e1858 = select(-1073741800f, _e1856, (_e1856 > -1073741800f));
let _e1860 = select(1073741800f, _e1858, (_e1858 < 1073741800f));
let _e1867 = select(0i, select(select(i32(_e1860), i32(-2147483648), (_e1860 < -2147483600f)), 2147483647i, (_e1860 > 2147483500f)), (_e1860 == _e1860));
let _e1871 = (_e1867 - select(0i, 1i, (_e1860 < f32(_e1867))));
let _e1873 = ((_e1517 * _e1744) + 0.5f);
let _e1875 = select(-1073741800f, _e1873, (_e1873 > -1073741800f));
let _e1877 = select(1073741800f, _e1875, (_e1875 < 1073741800f));
let _e1884 = select(0i, select(select(i32(_e1877), i32(-2147483648), (_e1877 < -2147483600f)), 2147483647i, (_e1877 > 2147483500f)), (_e1877 == _e1877));
let _e1890 = bitcast<u32>(_e1871);
let _e1894 = bitcast<u32>(((_e1884 - select(0i, 1i, (_e1877 < f32(_e1884)))) + (_e1871 >> bitcast<u32>(31i))));
if ((_e1890 | _e1894) == 0u) {
} else {
let _e1897 = bitcast<u32>((_e1748 + 2i));
if (_e1897 < _e58) {
let _e1900 = atomicAdd((&global_2.member[_e1897]), _e1890);
phi_3678_ = _e1900;
} else {
phi_3678_ = 0u;
}
let _e1902 = phi_3678_;
let _e1906 = (_e1894 + select(0u, 1u, ((_e1902 + _e1890) < _e1890)));
if (_e1906 == 0u) {
} else {
let _e1908 = (_e1897 + 1u);
if (_e1908 < _e58) {
let _e1911 = atomicAdd((&global_2.member[_e1908]), _e1906);
}
}
}
}
}
phi_3332_ = (_e1668 + 1i);
} else {
phi_3332_ = i32();
}
let _e1914 = phi_3332_;
continue;
continuing {
phi_3331_ = _e1914;
break if !(_e1670);
}
}
phi_3184_ = (_e1585 + 1i);
} else {
phi_3184_ = i32();
}
let _e1918 = phi_3184_;
continue;
continuing {
phi_3183_ = _e1918;
break if !(_e1586);
}
}
} else {
if ((_e1547 && (_e1537 > 2f)) && _e1550) {
let _e1937 = (bitcast<f32>((bitcast<u32>(_e1005) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u)));
let _e1944 = (bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u)));
let _e1945 = (_e1937 > _e1944);
let _e1947 = ((bitcast<f32>((bitcast<u32>(_e986) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e987) & 2147483647u))) > select(_e1944, _e1937, _e1945));
if _e1947 {
phi_3731_ = vec2<f32>(_e986, _e987);
} else {
if _e1945 {
phi_3730_ = vec2<f32>(_e1005, _e1007);
} else {
phi_3730_ = vec2<f32>(_e1538, _e1539);
}
let _e1951 = phi_3730_;
phi_3731_ = _e1951;
}
let _e1953 = phi_3731_;
if _e1947 {
phi_3741_ = vec2<f32>(_e658, _e668);
} else {
phi_3741_ = vec2<f32>(_e574, _e584);
}
let _e1957 = phi_3741_;
let _e1959 = select(1f, _e1537, (_e1537 > 1f));
let _e1961 = select(64f, _e1959, (_e1959 < 64f));
let _e1968 = select(0i, select(select(i32(_e1961), i32(-2147483648), (_e1961 < -2147483600f)), 2147483647i, (_e1961 > 2147483500f)), (_e1961 == _e1961));
let _e1973 = ((_e1968 - select(0i, 1i, (_e1961 < f32(_e1968)))) + 1i);
let _e1975 = (1f / f32(_e1973));
phi_3772_ = 0i;
loop {
let _e1977 = phi_3772_;
let _e1978 = (_e1977 < _e1973);
if _e1978 {
let _e1985 = ((f32(_e1977) + 0.5f) * _e1975);
let _e1988 = (_e1957.x + (_e1953.x * _e1985));
let _e1989 = (_e1957.y + (_e1953.y * _e1985));
let _e1991 = select(_e237, _e1988, (_e1988 > _e237));
let _e1993 = select(65536f, _e1991, (_e1991 < 65536f));
let _e2000 = select(0i, select(select(i32(_e1993), i32(-2147483648), (_e1993 < -2147483600f)), 2147483647i, (_e1993 > 2147483500f)), (_e1993 == _e1993));
let _e2004 = (_e2000 - select(0i, 1i, (_e1993 < f32(_e2000))));
let _e2006 = select(_e237, _e1989, (_e1989 > _e237));
let _e2008 = select(65536f, _e2006, (_e2006 < 65536f));
let _e2015 = select(0i, select(select(i32(_e2008), i32(-2147483648), (_e2008 < -2147483600f)), 2147483647i, (_e2008 > 2147483500f)), (_e2008 == _e2008));
let _e2019 = (_e2015 - select(0i, 1i, (_e2008 < f32(_e2015))));
let _e2021 = (_e1988 - f32(_e2004));
let _e2023 = (_e1989 - f32(_e2019));
phi_3855_ = 0i;
loop {
let _e2025 = phi_3855_;
let _e2026 = (_e2025 < 4i);
if _e2026 {
let _e2027 = (_e2025 & 1i);
let _e2029 = (_e2025 >> bitcast<u32>(1i));
if (_e2027 == 0i) {
phi_3870_ = (1f - _e2021);
} else {
phi_3870_ = _e2021;
}
let _e2033 = phi_3870_;
if (_e2029 == 0i) {
phi_3876_ = (1f - _e2023);
} else {
phi_3876_ = _e2023;
}
let _e2037 = phi_3876_;
let _e2038 = (_e2004 + _e2027);
let _e2039 = (_e2019 + _e2029);
let _e2045 = global_1.member.member_10.member_15;
let _e2046 = bitcast<i32>(_e2045);
let _e2048 = (firstTrailingBit(8u) & 31u);
let _e2050 = (_e2038 >> bitcast<u32>(_e2048));
let _e2052 = (_e2039 >> bitcast<u32>(_e2048));
let _e2057 = global_1.member.member_10.member_14.member;
let _e2058 = bitcast<i32>(_e2057);
let _e2063 = global_1.member.member_10.member_14.member_1;
let _e2064 = bitcast<i32>(_e2063);
let _e2069 = global_1.member.member_10.member_14.member_2;
if ((((((_e2050 >= 0i) && (_e2050 < _e2058)) && (_e2052 >= 0i)) && (_e2052 < _e2064)) && (_e2046 >= 0i)) && (_e2046 < bitcast<i32>(_e2069))) {
phi_3932_ = (((((_e2046 * _e2064) + _e2052) * _e2058) + _e2050) * 3i);
} else {
phi_3932_ = -1i;
}
let _e2088 = phi_3932_;
let _e2089 = (_e2088 + 2i);
let _e2091 = (bitcast<i32>(_e55) - 1i);
let _e2093 = select(_e2091, _e2089, (_e2089 < _e2091));
let _e2098 = global_4.member[bitcast<u32>(select(0i, _e2093, (_e2093 > 0i)))];
let _e2099 = bitcast<i32>(_e2098);
let _e2110 = select(((((_e2099 - 1i) * 64i) + ((_e2039 & 7i) * 8i)) + (_e2038 & 7i)), -1i, ((_e2088 < 0i) || (_e2099 == 0i)));
let _e2114 = global_1.member.member_10.member_20;
let _e2115 = (_e2114 * ((_e1975 * _e2033) * _e2037));
if ((_e2110 >= 0i) && (_e2115 > 0f)) {
let _e2119 = (_e2110 * 6i);
let _e2121 = ((_e1513 * _e2115) + 0.5f);
let _e2123 = select(-1073741800f, _e2121, (_e2121 > -1073741800f));
let _e2125 = select(1073741800f, _e2123, (_e2123 < 1073741800f));
let _e2132 = select(0i, select(select(i32(_e2125), i32(-2147483648), (_e2125 < -2147483600f)), 2147483647i, (_e2125 > 2147483500f)), (_e2125 == _e2125));
let _e2136 = (_e2132 - select(0i, 1i, (_e2125 < f32(_e2132))));
let _e2141 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e2141 {
phi_4040_ = 0i;
} else {
let _e2143 = ((_e1514 * _e2115) + 0.5f);
let _e2145 = select(-1073741800f, _e2143, (_e2143 > -1073741800f));
let _e2147 = select(1073741800f, _e2145, (_e2145 < 1073741800f));
let _e2154 = select(0i, select(select(i32(_e2147), i32(-2147483648), (_e2147 < -2147483600f)), 2147483647i, (_e2147 > 2147483500f)), (_e2147 == _e2147));
phi_4040_ = (_e2154 - select(0i, 1i, (_e2147 < f32(_e2154))));
}
let _e2160 = phi_4040_;
let _e2161 = bitcast<u32>(_e2136);
let _e2165 = bitcast<u32>((_e2160 + (_e2136 >> bitcast<u32>(31i))));
if ((_e2161 | _e2165) == 0u) {
} else {
let _e2168 = bitcast<u32>(_e2119);
if (_e2168 < _e58) {
let _e2171 = atomicAdd((&global_2.member[_e2168]), _e2161);
phi_4059_ = _e2171;
} else {
phi_4059_ = 0u;
}
let _e2173 = phi_4059_;
let _e2177 = (_e2165 + select(0u, 1u, ((_e2173 + _e2161) < _e2161)));
if (_e2177 == 0u) {
} else {
let _e2179 = (_e2168 + 1u);
if (_e2179 < _e58) {
let _e2182 = atomicAdd((&global_2.member[_e2179]), _e2177);
}
}
}
if _e2141 {
} else {
let _e2185 = ((_e1515 * _e2115) + 0.5f);
let _e2187 = select(-1073741800f, _e2185, (_e2185 > -1073741800f));
let _e2189 = select(1073741800f, _e2187, (_e2187 < 1073741800f));
let _e2196 = select(0i, select(select(i32(_e2189), i32(-2147483648), (_e2189 < -2147483600f)), 2147483647i, (_e2189 > 2147483500f)), (_e2189 == _e2189));
let _e2200 = (_e2196 - select(0i, 1i, (_e2189 < f32(_e2196))));
let _e2201 = bitcast<u32>(_e2200);
let _e2204 = bitcast<u32>((_e2200 >> bitcast<u32>(31i)));
if ((_e2201 | _e2204) == 0u) {
} else {
let _e2207 = bitcast<u32>((_e2119 + 4i));
if (_e2207 < _e58) {
let _e2210 = atomicAdd((&global_2.member[_e2207]), _e2201);
phi_4127_ = _e2210;
} else {
phi_4127_ = 0u;
}
let _e2212 = phi_4127_;
let _e2216 = (_e2204 + select(0u, 1u, ((_e2212 + _e2201) < _e2201)));
if (_e2216 == 0u) {
} else {
let _e2218 = (_e2207 + 1u);
if (_e2218 < _e58) {
let _e2221 = atomicAdd((&global_2.member[_e2218]), _e2216);
}
}
}
}
let _e2224 = global_1.member.member_20;
if (_e2224 > 0f) {
let _e2227 = ((_e1516 * _e2115) + 0.5f);
let _e2229 = select(-1073741800f, _e2227, (_e2227 > -1073741800f));
let _e2231 = select(1073741800f, _e2229, (_e2229 < 1073741800f));
let _e2238 = select(0i, select(select(i32(_e2231), i32(-2147483648), (_e2231 < -2147483600f)), 2147483647i, (_e2231 > 2147483500f)), (_e2231 == _e2231));
let _e2242 = (_e2238 - select(0i, 1i, (_e2231 < f32(_e2238))));
let _e2244 = ((_e1517 * _e2115) + 0.5f);
let _e2246 = select(-1073741800f, _e2244, (_e2244 > -1073741800f));
let _e2248 = select(1073741800f, _e2246, (_e2246 < 1073741800f));
let _e2255 = select(0i, select(select(i32(_e2248), i32(-2147483648), (_e2248 < -2147483600f)), 2147483647i, (_e2248 > 2147483500f)), (_e2248 == _e2248));
let _e2261 = bitcast<u32>(_e2242);
let _e2265 = bitcast<u32>(((_e2255 - select(0i, 1i, (_e2248 < f32(_e2255)))) + (_e2242 >> bitcast<u32>(31i))));
if ((_e2261 | _e2265) == 0u) {
} else {
let _e2268 = bitcast<u32>((_e2119 + 2i));
if (_e2268 < _e58) {
let _e2271 = atomicAdd((&global_2.member[_e2268]), _e2261);
phi_4219_ = _e2271;
} else {
phi_4219_ = 0u;
}
let _e2273 = phi_4219_;
let _e2277 = (_e2265 + select(0u, 1u, ((_e2273 + _e2261) < _e2261)));
if (_e2277 == 0u) {
} else {
let _e2279 = (_e2268 + 1u);
if (_e2279 < _e58) {
let _e2282 = atomicAdd((&global_2.member[_e2279]), _e2277);
}
}
}
}
}
phi_3856_ = (_e2025 + 1i);
} else {
phi_3856_ = i32();
}
let _e2285 = phi_3856_;
continue;
continuing {
phi_3855_ = _e2285;
break if !(_e2026);
}
}
phi_3773_ = (_e1977 + 1i);
} else {
phi_3773_ = i32();
}
let _e2289 = phi_3773_;
continue;
continuing {
phi_3772_ = _e2289;
break if !(_e1978);
}
}
} else {
if ((_e1470 > 0f) && (!(_e1547) || (_e1537 <= 2f))) {
let _e2306 = (1f / _e1470);
let _e2307 = ((((_e574 * _e1466) + (_e658 * _e1467)) + (_e742 * _e1468)) * _e2306);
let _e2308 = ((((_e584 * _e1466) + (_e668 * _e1467)) + (_e752 * _e1468)) * _e2306);
let _e2310 = select(_e237, _e2307, (_e2307 > _e237));
let _e2312 = select(65536f, _e2310, (_e2310 < 65536f));
let _e2319 = select(0i, select(select(i32(_e2312), i32(-2147483648), (_e2312 < -2147483600f)), 2147483647i, (_e2312 > 2147483500f)), (_e2312 == _e2312));
let _e2323 = (_e2319 - select(0i, 1i, (_e2312 < f32(_e2319))));
let _e2325 = select(_e237, _e2308, (_e2308 > _e237));
let _e2327 = select(65536f, _e2325, (_e2325 < 65536f));
let _e2334 = select(0i, select(select(i32(_e2327), i32(-2147483648), (_e2327 < -2147483600f)), 2147483647i, (_e2327 > 2147483500f)), (_e2327 == _e2327));
let _e2338 = (_e2334 - select(0i, 1i, (_e2327 < f32(_e2334))));
let _e2340 = (_e2307 - f32(_e2323));
let _e2342 = (_e2308 - f32(_e2338));
phi_4328_ = 0i;
loop {
let _e2344 = phi_4328_;
let _e2345 = (_e2344 < 4i);
if _e2345 {
let _e2346 = (_e2344 & 1i);
let _e2348 = (_e2344 >> bitcast<u32>(1i));
if (_e2346 == 0i) {
phi_4343_ = (1f - _e2340);
} else {
phi_4343_ = _e2340;
}
let _e2352 = phi_4343_;
if (_e2348 == 0i) {
phi_4349_ = (1f - _e2342);
} else {
phi_4349_ = _e2342;
}
let _e2356 = phi_4349_;
let _e2357 = (_e2323 + _e2346);
let _e2358 = (_e2338 + _e2348);
let _e2364 = global_1.member.member_10.member_15;
let _e2365 = bitcast<i32>(_e2364);
let _e2367 = (firstTrailingBit(8u) & 31u);
let _e2369 = (_e2357 >> bitcast<u32>(_e2367));
let _e2371 = (_e2358 >> bitcast<u32>(_e2367));
let _e2376 = global_1.member.member_10.member_14.member;
let _e2377 = bitcast<i32>(_e2376);
let _e2382 = global_1.member.member_10.member_14.member_1;
let _e2383 = bitcast<i32>(_e2382);
let _e2388 = global_1.member.member_10.member_14.member_2;
if ((((((_e2369 >= 0i) && (_e2369 < _e2377)) && (_e2371 >= 0i)) && (_e2371 < _e2383)) && (_e2365 >= 0i)) && (_e2365 < bitcast<i32>(_e2388))) {
phi_4405_ = (((((_e2365 * _e2383) + _e2371) * _e2377) + _e2369) * 3i);
} else {
phi_4405_ = -1i;
}
let _e2407 = phi_4405_;
let _e2408 = (_e2407 + 2i);
let _e2410 = (bitcast<i32>(_e55) - 1i);
let _e2412 = select(_e2410, _e2408, (_e2408 < _e2410));
let _e2417 = global_4.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2418 = bitcast<i32>(_e2417);
let _e2429 = select(((((_e2418 - 1i) * 64i) + ((_e2358 & 7i) * 8i)) + (_e2357 & 7i)), -1i, ((_e2407 < 0i) || (_e2418 == 0i)));
let _e2433 = global_1.member.member_10.member_20;
let _e2434 = (_e2433 * ((1f * _e2352) * _e2356));
if ((_e2429 >= 0i) && (_e2434 > 0f)) {
let _e2438 = (_e2429 * 6i);
let _e2440 = ((_e1513 * _e2434) + 0.5f);
let _e2442 = select(-1073741800f, _e2440, (_e2440 > -1073741800f));
let _e2444 = select(1073741800f, _e2442, (_e2442 < 1073741800f));
let _e2451 = select(0i, select(select(i32(_e2444), i32(-2147483648), (_e2444 < -2147483600f)), 2147483647i, (_e2444 > 2147483500f)), (_e2444 == _e2444));
let _e2455 = (_e2451 - select(0i, 1i, (_e2444 < f32(_e2451))));
let _e2460 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e2460 {
phi_4513_ = 0i;
} else {
let _e2462 = ((_e1514 * _e2434) + 0.5f);
let _e2464 = select(-1073741800f, _e2462, (_e2462 > -1073741800f));
let _e2466 = select(1073741800f, _e2464, (_e2464 < 1073741800f));
let _e2473 = select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466));
phi_4513_ = (_e2473 - select(0i, 1i, (_e2466 < f32(_e2473))));
}
let _e2479 = phi_4513_;
let _e2480 = bitcast<u32>(_e2455);
let _e2484 = bitcast<u32>((_e2479 + (_e2455 >> bitcast<u32>(31i))));
if ((_e2480 | _e2484) == 0u) {
} else {
let _e2487 = bitcast<u32>(_e2438);
if (_e2487 < _e58) {
let _e2490 = atomicAdd((&global_2.member[_e2487]), _e2480);
phi_4532_ = _e2490;
} else {
phi_4532_ = 0u;
}
let _e2492 = phi_4532_;
let _e2496 = (_e2484 + select(0u, 1u, ((_e2492 + _e2480) < _e2480)));
if (_e2496 == 0u) {
} else {
let _e2498 = (_e2487 + 1u);
if (_e2498 < _e58) {
let _e2501 = atomicAdd((&global_2.member[_e2498]), _e2496);
}
}
}
if _e2460 {
} else {
let _e2504 = ((_e1515 * _e2434) + 0.5f);
let _e2506 = select(-1073741800f, _e2504, (_e2504 > -1073741800f));
let _e2508 = select(1073741800f, _e2506, (_e2506 < 1073741800f));
let _e2515 = select(0i, select(select(i32(_e2508), i32(-2147483648), (_e2508 < -2147483600f)), 2147483647i, (_e2508 > 2147483500f)), (_e2508 == _e2508));
let _e2519 = (_e2515 - select(0i, 1i, (_e2508 < f32(_e2515))));
let _e2520 = bitcast<u32>(_e2519);
let _e2523 = bitcast<u32>((_e2519 >> bitcast<u32>(31i)));
if ((_e2520 | _e2523) == 0u) {
} else {
let _e2526 = bitcast<u32>((_e2438 + 4i));
if (_e2526 < _e58) {
let _e2529 = atomicAdd((&global_2.member[_e2526]), _e2520);
phi_4600_ = _e2529;
} else {
phi_4600_ = 0u;
}
let _e2531 = phi_4600_;
let _e2535 = (_e2523 + select(0u, 1u, ((_e2531 + _e2520) < _e2520)));
if (_e2535 == 0u) {
} else {
let _e2537 = (_e2526 + 1u);
if (_e2537 < _e58) {
let _e2540 = atomicAdd((&global_2.member[_e2537]), _e2535);
}
}
}
}
let _e2543 = global_1.member.member_20;
if (_e2543 > 0f) {
let _e2546 = ((_e1516 * _e2434) + 0.5f);
let _e2548 = select(-1073741800f, _e2546, (_e2546 > -1073741800f));
let _e2550 = select(1073741800f, _e2548, (_e2548 < 1073741800f));
let _e2557 = select(0i, select(select(i32(_e2550), i32(-2147483648), (_e2550 < -2147483600f)), 2147483647i, (_e2550 > 2147483500f)), (_e2550 == _e2550));
let _e2561 = (_e2557 - select(0i, 1i, (_e2550 < f32(_e2557))));
let _e2563 = ((_e1517 * _e2434) + 0.5f);
let _e2565 = select(-1073741800f, _e2563, (_e2563 > -1073741800f));
let _e2567 = select(1073741800f, _e2565, (_e2565 < 1073741800f));
let _e2574 = select(0i, select(select(i32(_e2567), i32(-2147483648), (_e2567 < -2147483600f)), 2147483647i, (_e2567 > 2147483500f)), (_e2567 == _e2567));
let _e2580 = bitcast<u32>(_e2561);
let _e2584 = bitcast<u32>(((_e2574 - select(0i, 1i, (_e2567 < f32(_e2574)))) + (_e2561 >> bitcast<u32>(31i))));
if ((_e2580 | _e2584) == 0u) {
} else {
let _e2587 = bitcast<u32>((_e2438 + 2i));
if (_e2587 < _e58) {
let _e2590 = atomicAdd((&global_2.member[_e2587]), _e2580);
phi_4692_ = _e2590;
} else {
phi_4692_ = 0u;
}
let _e2592 = phi_4692_;
let _e2596 = (_e2584 + select(0u, 1u, ((_e2592 + _e2580) < _e2580)));
if (_e2596 == 0u) {
} else {
let _e2598 = (_e2587 + 1u);
if (_e2598 < _e58) {
let _e2601 = atomicAdd((&global_2.member[_e2598]), _e2596);
}
}
}
}
}
phi_4329_ = (_e2344 + 1i);
} else {
phi_4329_ = i32();
}
let _e2604 = phi_4329_;
continue;
continuing {
phi_4328_ = _e2604;
break if !(_e2345);
}
}
}
}
}
let _e2606 = select(1f, 0f, _e1042);
let _e2608 = ((_e2606 + _e1467) + _e1468);
let _e2620 = (((_e847 + _e858) + _e869) * _e1488);
let _e2629 = ((((_e847 * _e2606) + _e1474) + _e1480) * _e1512);
let _e2630 = ((((_e858 * _e2606) + _e1475) + _e1481) * _e1512);
let _e2631 = ((((_e869 * _e2606) + _e1476) + _e1482) * _e1512);
let _e2632 = (((((_e880 * _e2620) * _e2606) + _e1499) + _e1508) * _e1512);
let _e2633 = (((((_e891 * _e2620) * _e2606) + _e1500) + _e1509) * _e1512);
let _e2635 = select(_e658, _e826, (_e826 < _e658));
let _e2639 = select(_e668, _e836, (_e836 < _e668));
let _e2641 = select(_e752, _e2639, (_e2639 < _e752));
let _e2643 = select(_e658, _e826, (_e826 > _e658));
let _e2647 = select(_e668, _e836, (_e836 > _e668));
let _e2649 = select(_e752, _e2647, (_e2647 > _e752));
let _e2650 = (select(_e742, _e2643, (_e2643 > _e742)) - select(_e742, _e2635, (_e2635 < _e742)));
let _e2651 = (_e2649 - _e2641);
let _e2653 = select(_e2651, _e2650, (_e2650 > _e2651));
let _e2654 = (_e658 - _e826);
let _e2655 = (_e668 - _e836);
let _e2662 = (0.5f * bitcast<f32>((bitcast<u32>(((_e2654 * _e1018) - (_e2655 * _e1015))) & 2147483647u)));
let _e2663 = (_e2608 == 3f);
let _e2666 = (_e2653 <= 64f);
if ((_e2663 && (_e2662 >= 0.25f)) && _e2666) {
let _e2670 = select(_e237, _e2641, (_e2641 > _e237));
let _e2672 = select(65536f, _e2670, (_e2670 < 65536f));
let _e2679 = select(0i, select(select(i32(_e2672), i32(-2147483648), (_e2672 < -2147483600f)), 2147483647i, (_e2672 > 2147483500f)), (_e2672 == _e2672));
let _e2686 = select(_e237, _e2649, (_e2649 > _e237));
let _e2688 = select(65536f, _e2686, (_e2686 < 65536f));
let _e2695 = select(0i, select(select(i32(_e2688), i32(-2147483648), (_e2688 < -2147483600f)), 2147483647i, (_e2688 > 2147483500f)), (_e2688 == _e2688));
phi_5017_ = ((_e2679 - select(0i, 1i, (_e2672 < f32(_e2679)))) + 1i);
loop {
let _e2701 = phi_5017_;
let _e2702 = (_e2701 <= (_e2695 - select(0i, 1i, (_e2688 < f32(_e2695)))));
if _e2702 {
let _e2703 = f32(_e2701);
let _e2704 = (_e836 <= _e2703);
let _e2705 = (_e668 <= _e2703);
if (_e2704 != _e2705) {
let _e2710 = (_e826 + ((_e2703 - _e836) * (_e2654 / _e2655)));
phi_5051_ = type_28(select(_e2710, 65536f, (65536f < _e2710)), select(_e2710, _e237, (_e237 > _e2710)));
} else {
phi_5051_ = type_28(65536f, _e237);
}
let _e2718 = phi_5051_;
let _e2721 = (_e752 <= _e2703);
if (_e2705 != _e2721) {
let _e2726 = (_e658 + ((_e2703 - _e668) * (_e986 / _e987)));
phi_5078_ = type_28(select(_e2726, _e2718.member, (_e2718.member < _e2726)), select(_e2726, _e2718.member_1, (_e2718.member_1 > _e2726)));
} else {
phi_5078_ = _e2718;
}
let _e2733 = phi_5078_;
if (_e2721 != _e2721) {
let _e2742 = (_e742 + ((_e2703 - _e752) * ((_e742 - _e742) / (_e752 - _e752))));
phi_5105_ = type_28(select(_e2742, _e2733.member, (_e2733.member < _e2742)), select(_e2742, _e2733.member_1, (_e2733.member_1 > _e2742)));
} else {
phi_5105_ = _e2733;
}
let _e2749 = phi_5105_;
if (_e2721 != _e2704) {
let _e2758 = (_e742 + ((_e2703 - _e752) * ((_e826 - _e742) / (_e836 - _e752))));
phi_5132_ = type_28(select(_e2758, _e2749.member, (_e2749.member < _e2758)), select(_e2758, _e2749.member_1, (_e2749.member_1 > _e2758)));
} else {
phi_5132_ = _e2749;
}
let _e2765 = phi_5132_;
let _e2768 = -(_e2765.member);
let _e2770 = select(_e237, _e2768, (_e2768 > _e237));
let _e2772 = select(65536f, _e2770, (_e2770 < 65536f));
let _e2779 = select(0i, select(select(i32(_e2772), i32(-2147483648), (_e2772 < -2147483600f)), 2147483647i, (_e2772 > 2147483500f)), (_e2772 == _e2772));
phi_5165_ = -((_e2779 - select(0i, 1i, (_e2772 < f32(_e2779)))));
loop {
let _e2786 = phi_5165_;
let _e2788 = (f32(_e2786) < _e2765.member_1);
if _e2788 {
let _e2792 = global_1.member.member_10.member_15;
let _e2793 = bitcast<i32>(_e2792);
let _e2795 = (firstTrailingBit(8u) & 31u);
let _e2797 = (_e2786 >> bitcast<u32>(_e2795));
let _e2799 = (_e2701 >> bitcast<u32>(_e2795));
let _e2804 = global_1.member.member_10.member_14.member;
let _e2805 = bitcast<i32>(_e2804);
let _e2810 = global_1.member.member_10.member_14.member_1;
let _e2811 = bitcast<i32>(_e2810);
let _e2816 = global_1.member.member_10.member_14.member_2;
if ((((((_e2797 >= 0i) && (_e2797 < _e2805)) && (_e2799 >= 0i)) && (_e2799 < _e2811)) && (_e2793 >= 0i)) && (_e2793 < bitcast<i32>(_e2816))) {
phi_5225_ = (((((_e2793 * _e2811) + _e2799) * _e2805) + _e2797) * 3i);
} else {
phi_5225_ = -1i;
}
let _e2835 = phi_5225_;
let _e2836 = (_e2835 + 2i);
let _e2838 = (bitcast<i32>(_e55) - 1i);
let _e2840 = select(_e2838, _e2836, (_e2836 < _e2838));
let _e2845 = global_4.member[bitcast<u32>(select(0i, _e2840, (_e2840 > 0i)))];
let _e2846 = bitcast<i32>(_e2845);
let _e2857 = select(((((_e2846 - 1i) * 64i) + ((_e2701 & 7i) * 8i)) + (_e2786 & 7i)), -1i, ((_e2835 < 0i) || (_e2846 == 0i)));
let _e2861 = global_1.member.member_10.member_20;
let _e2862 = (_e2861 * (1f / _e2662));
if ((_e2857 >= 0i) && (_e2862 > 0f)) {
let _e2866 = (_e2857 * 6i);
let _e2868 = ((_e2629 * _e2862) + 0.5f);
let _e2870 = select(-1073741800f, _e2868, (_e2868 > -1073741800f));
let _e2872 = select(1073741800f, _e2870, (_e2870 < 1073741800f));
let _e2879 = select(0i, select(select(i32(_e2872), i32(-2147483648), (_e2872 < -2147483600f)), 2147483647i, (_e2872 > 2147483500f)), (_e2872 == _e2872));
let _e2883 = (_e2879 - select(0i, 1i, (_e2872 < f32(_e2879))));
let _e2888 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e2888 {
phi_5333_ = 0i;
} else {
let _e2890 = ((_e2630 * _e2862) + 0.5f);
let _e2892 = select(-1073741800f, _e2890, (_e2890 > -1073741800f));
let _e2894 = select(1073741800f, _e2892, (_e2892 < 1073741800f));
let _e2901 = select(0i, select(select(i32(_e2894), i32(-2147483648), (_e2894 < -2147483600f)), 2147483647i, (_e2894 > 2147483500f)), (_e2894 == _e2894));
phi_5333_ = (_e2901 - select(0i, 1i, (_e2894 < f32(_e2901))));
}
let _e2907 = phi_5333_;
let _e2908 = bitcast<u32>(_e2883);
let _e2912 = bitcast<u32>((_e2907 + (_e2883 >> bitcast<u32>(31i))));
if ((_e2908 | _e2912) == 0u) {
} else {
let _e2915 = bitcast<u32>(_e2866);
if (_e2915 < _e58) {
let _e2918 = atomicAdd((&global_2.member[_e2915]), _e2908);
phi_5352_ = _e2918;
} else {
phi_5352_ = 0u;
}
let _e2920 = phi_5352_;
let _e2924 = (_e2912 + select(0u, 1u, ((_e2920 + _e2908) < _e2908)));
if (_e2924 == 0u) {
} else {
let _e2926 = (_e2915 + 1u);
if (_e2926 < _e58) {
let _e2929 = atomicAdd((&global_2.member[_e2926]), _e2924);
}
}
}
if _e2888 {
} else {
let _e2932 = ((_e2631 * _e2862) + 0.5f);
let _e2934 = select(-1073741800f, _e2932, (_e2932 > -1073741800f));
let _e2936 = select(1073741800f, _e2934, (_e2934 < 1073741800f));
let _e2943 = select(0i, select(select(i32(_e2936), i32(-2147483648), (_e2936 < -2147483600f)), 2147483647i, (_e2936 > 2147483500f)), (_e2936 == _e2936));
let _e2947 = (_e2943 - select(0i, 1i, (_e2936 < f32(_e2943))));
let _e2948 = bitcast<u32>(_e2947);
let _e2951 = bitcast<u32>((_e2947 >> bitcast<u32>(31i)));
if ((_e2948 | _e2951) == 0u) {
} else {
let _e2954 = bitcast<u32>((_e2866 + 4i));
if (_e2954 < _e58) {
let _e2957 = atomicAdd((&global_2.member[_e2954]), _e2948);
phi_5420_ = _e2957;
} else {
phi_5420_ = 0u;
}
let _e2959 = phi_5420_;
let _e2963 = (_e2951 + select(0u, 1u, ((_e2959 + _e2948) < _e2948)));
if (_e2963 == 0u) {
} else {
let _e2965 = (_e2954 + 1u);
if (_e2965 < _e58) {
let _e2968 = atomicAdd((&global_2.member[_e2965]), _e2963);
}
}
}
}
let _e2971 = global_1.member.member_20;
if (_e2971 > 0f) {
let _e2974 = ((_e2632 * _e2862) + 0.5f);
let _e2976 = select(-1073741800f, _e2974, (_e2974 > -1073741800f));
let _e2978 = select(1073741800f, _e2976, (_e2976 < 1073741800f));
let _e2985 = select(0i, select(select(i32(_e2978), i32(-2147483648), (_e2978 < -2147483600f)), 2147483647i, (_e2978 > 2147483500f)), (_e2978 == _e2978));
let _e2989 = (_e2985 - select(0i, 1i, (_e2978 < f32(_e2985))));
let _e2991 = ((_e2633 * _e2862) + 0.5f);
let _e2993 = select(-1073741800f, _e2991, (_e2991 > -1073741800f));
let _e2995 = select(1073741800f, _e2993, (_e2993 < 1073741800f));
let _e3002 = select(0i, select(select(i32(_e2995), i32(-2147483648), (_e2995 < -2147483600f)), 2147483647i, (_e2995 > 2147483500f)), (_e2995 == _e2995));
let _e3008 = bitcast<u32>(_e2989);
let _e3012 = bitcast<u32>(((_e3002 - select(0i, 1i, (_e2995 < f32(_e3002)))) + (_e2989 >> bitcast<u32>(31i))));
if ((_e3008 | _e3012) == 0u) {
} else {
let _e3015 = bitcast<u32>((_e2866 + 2i));
if (_e3015 < _e58) {
let _e3018 = atomicAdd((&global_2.member[_e3015]), _e3008);
phi_5512_ = _e3018;
} else {
phi_5512_ = 0u;
}
let _e3020 = phi_5512_;
let _e3024 = (_e3012 + select(0u, 1u, ((_e3020 + _e3008) < _e3008)));
if (_e3024 == 0u) {
} else {
let _e3026 = (_e3015 + 1u);
if (_e3026 < _e58) {
let _e3029 = atomicAdd((&global_2.member[_e3026]), _e3024);
}
}
}
}
}
phi_5166_ = (_e2786 + 1i);
} else {
phi_5166_ = i32();
}
let _e3032 = phi_5166_;
continue;
continuing {
phi_5165_ = _e3032;
break if !(_e2788);
}
}
phi_5018_ = (_e2701 + 1i);
} else {
phi_5018_ = i32();
}
let _e3036 = phi_5018_;
continue;
continuing {
phi_5017_ = _e3036;
break if !(_e2702);
}
}
} else {
if ((_e2663 && (_e2653 > 2f)) && _e2666) {
let _e3055 = (bitcast<f32>((bitcast<u32>(_e2654) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2655) & 2147483647u)));
let _e3062 = (bitcast<f32>((bitcast<u32>(_e1015) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u)));
let _e3063 = (_e3055 > _e3062);
let _e3065 = ((bitcast<f32>((bitcast<u32>(_e986) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e987) & 2147483647u))) > select(_e3062, _e3055, _e3063));
if _e3065 {
phi_5565_ = vec2<f32>(_e986, _e987);
} else {
if _e3063 {
phi_5564_ = vec2<f32>(_e2654, _e2655);
} else {
phi_5564_ = vec2<f32>(_e1015, _e1018);
}
let _e3069 = phi_5564_;
phi_5565_ = _e3069;
}
let _e3071 = phi_5565_;
if _e3065 {
phi_5575_ = vec2<f32>(_e658, _e668);
} else {
phi_5575_ = vec2<f32>(_e826, _e836);
}
let _e3075 = phi_5575_;
let _e3077 = select(1f, _e2653, (_e2653 > 1f));
let _e3079 = select(64f, _e3077, (_e3077 < 64f));
let _e3086 = select(0i, select(select(i32(_e3079), i32(-2147483648), (_e3079 < -2147483600f)), 2147483647i, (_e3079 > 2147483500f)), (_e3079 == _e3079));
let _e3091 = ((_e3086 - select(0i, 1i, (_e3079 < f32(_e3086)))) + 1i);
let _e3093 = (1f / f32(_e3091));
phi_5606_ = 0i;
loop {
let _e3095 = phi_5606_;
let _e3096 = (_e3095 < _e3091);
if _e3096 {
let _e3103 = ((f32(_e3095) + 0.5f) * _e3093);
let _e3106 = (_e3075.x + (_e3071.x * _e3103));
let _e3107 = (_e3075.y + (_e3071.y * _e3103));
let _e3109 = select(_e237, _e3106, (_e3106 > _e237));
let _e3111 = select(65536f, _e3109, (_e3109 < 65536f));
let _e3118 = select(0i, select(select(i32(_e3111), i32(-2147483648), (_e3111 < -2147483600f)), 2147483647i, (_e3111 > 2147483500f)), (_e3111 == _e3111));
let _e3122 = (_e3118 - select(0i, 1i, (_e3111 < f32(_e3118))));
let _e3124 = select(_e237, _e3107, (_e3107 > _e237));
let _e3126 = select(65536f, _e3124, (_e3124 < 65536f));
let _e3133 = select(0i, select(select(i32(_e3126), i32(-2147483648), (_e3126 < -2147483600f)), 2147483647i, (_e3126 > 2147483500f)), (_e3126 == _e3126));
let _e3137 = (_e3133 - select(0i, 1i, (_e3126 < f32(_e3133))));
let _e3139 = (_e3106 - f32(_e3122));
let _e3141 = (_e3107 - f32(_e3137));
phi_5689_ = 0i;
loop {
let _e3143 = phi_5689_;
let _e3144 = (_e3143 < 4i);
if _e3144 {
let _e3145 = (_e3143 & 1i);
let _e3147 = (_e3143 >> bitcast<u32>(1i));
if (_e3145 == 0i) {
phi_5704_ = (1f - _e3139);
} else {
phi_5704_ = _e3139;
}
let _e3151 = phi_5704_;
if (_e3147 == 0i) {
phi_5710_ = (1f - _e3141);
} else {
phi_5710_ = _e3141;
}
let _e3155 = phi_5710_;
let _e3156 = (_e3122 + _e3145);
let _e3157 = (_e3137 + _e3147);
let _e3163 = global_1.member.member_10.member_15;
let _e3164 = bitcast<i32>(_e3163);
let _e3166 = (firstTrailingBit(8u) & 31u);
let _e3168 = (_e3156 >> bitcast<u32>(_e3166));
let _e3170 = (_e3157 >> bitcast<u32>(_e3166));
let _e3175 = global_1.member.member_10.member_14.member;
let _e3176 = bitcast<i32>(_e3175);
let _e3181 = global_1.member.member_10.member_14.member_1;
let _e3182 = bitcast<i32>(_e3181);
let _e3187 = global_1.member.member_10.member_14.member_2;
if ((((((_e3168 >= 0i) && (_e3168 < _e3176)) && (_e3170 >= 0i)) && (_e3170 < _e3182)) && (_e3164 >= 0i)) && (_e3164 < bitcast<i32>(_e3187))) {
phi_5766_ = (((((_e3164 * _e3182) + _e3170) * _e3176) + _e3168) * 3i);
} else {
phi_5766_ = -1i;
}
let _e3206 = phi_5766_;
let _e3207 = (_e3206 + 2i);
let _e3209 = (bitcast<i32>(_e55) - 1i);
let _e3211 = select(_e3209, _e3207, (_e3207 < _e3209));
let _e3216 = global_4.member[bitcast<u32>(select(0i, _e3211, (_e3211 > 0i)))];
let _e3217 = bitcast<i32>(_e3216);
let _e3228 = select(((((_e3217 - 1i) * 64i) + ((_e3157 & 7i) * 8i)) + (_e3156 & 7i)), -1i, ((_e3206 < 0i) || (_e3217 == 0i)));
let _e3232 = global_1.member.member_10.member_20;
let _e3233 = (_e3232 * ((_e3093 * _e3151) * _e3155));
if ((_e3228 >= 0i) && (_e3233 > 0f)) {
let _e3237 = (_e3228 * 6i);
let _e3239 = ((_e2629 * _e3233) + 0.5f);
let _e3241 = select(-1073741800f, _e3239, (_e3239 > -1073741800f));
let _e3243 = select(1073741800f, _e3241, (_e3241 < 1073741800f));
let _e3250 = select(0i, select(select(i32(_e3243), i32(-2147483648), (_e3243 < -2147483600f)), 2147483647i, (_e3243 > 2147483500f)), (_e3243 == _e3243));
let _e3254 = (_e3250 - select(0i, 1i, (_e3243 < f32(_e3250))));
let _e3259 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e3259 {
phi_5874_ = 0i;
} else {
let _e3261 = ((_e2630 * _e3233) + 0.5f);
let _e3263 = select(-1073741800f, _e3261, (_e3261 > -1073741800f));
let _e3265 = select(1073741800f, _e3263, (_e3263 < 1073741800f));
let _e3272 = select(0i, select(select(i32(_e3265), i32(-2147483648), (_e3265 < -2147483600f)), 2147483647i, (_e3265 > 2147483500f)), (_e3265 == _e3265));
phi_5874_ = (_e3272 - select(0i, 1i, (_e3265 < f32(_e3272))));
}
let _e3278 = phi_5874_;
let _e3279 = bitcast<u32>(_e3254);
let _e3283 = bitcast<u32>((_e3278 + (_e3254 >> bitcast<u32>(31i))));
if ((_e3279 | _e3283) == 0u) {
} else {
let _e3286 = bitcast<u32>(_e3237);
if (_e3286 < _e58) {
let _e3289 = atomicAdd((&global_2.member[_e3286]), _e3279);
phi_5893_ = _e3289;
} else {
phi_5893_ = 0u;
}
let _e3291 = phi_5893_;
let _e3295 = (_e3283 + select(0u, 1u, ((_e3291 + _e3279) < _e3279)));
if (_e3295 == 0u) {
} else {
let _e3297 = (_e3286 + 1u);
if (_e3297 < _e58) {
let _e3300 = atomicAdd((&global_2.member[_e3297]), _e3295);
}
}
}
if _e3259 {
} else {
let _e3303 = ((_e2631 * _e3233) + 0.5f);
let _e3305 = select(-1073741800f, _e3303, (_e3303 > -1073741800f));
let _e3307 = select(1073741800f, _e3305, (_e3305 < 1073741800f));
let _e3314 = select(0i, select(select(i32(_e3307), i32(-2147483648), (_e3307 < -2147483600f)), 2147483647i, (_e3307 > 2147483500f)), (_e3307 == _e3307));
let _e3318 = (_e3314 - select(0i, 1i, (_e3307 < f32(_e3314))));
let _e3319 = bitcast<u32>(_e3318);
let _e3322 = bitcast<u32>((_e3318 >> bitcast<u32>(31i)));
if ((_e3319 | _e3322) == 0u) {
} else {
let _e3325 = bitcast<u32>((_e3237 + 4i));
if (_e3325 < _e58) {
let _e3328 = atomicAdd((&global_2.member[_e3325]), _e3319);
phi_5961_ = _e3328;
} else {
phi_5961_ = 0u;
}
let _e3330 = phi_5961_;
let _e3334 = (_e3322 + select(0u, 1u, ((_e3330 + _e3319) < _e3319)));
if (_e3334 == 0u) {
} else {
let _e3336 = (_e3325 + 1u);
if (_e3336 < _e58) {
let _e3339 = atomicAdd((&global_2.member[_e3336]), _e3334);
}
}
}
}
let _e3342 = global_1.member.member_20;
if (_e3342 > 0f) {
let _e3345 = ((_e2632 * _e3233) + 0.5f);
let _e3347 = select(-1073741800f, _e3345, (_e3345 > -1073741800f));
let _e3349 = select(1073741800f, _e3347, (_e3347 < 1073741800f));
let _e3356 = select(0i, select(select(i32(_e3349), i32(-2147483648), (_e3349 < -2147483600f)), 2147483647i, (_e3349 > 2147483500f)), (_e3349 == _e3349));
let _e3360 = (_e3356 - select(0i, 1i, (_e3349 < f32(_e3356))));
let _e3362 = ((_e2633 * _e3233) + 0.5f);
let _e3364 = select(-1073741800f, _e3362, (_e3362 > -1073741800f));
let _e3366 = select(1073741800f, _e3364, (_e3364 < 1073741800f));
let _e3373 = select(0i, select(select(i32(_e3366), i32(-2147483648), (_e3366 < -2147483600f)), 2147483647i, (_e3366 > 2147483500f)), (_e3366 == _e3366));
let _e3379 = bitcast<u32>(_e3360);
let _e3383 = bitcast<u32>(((_e3373 - select(0i, 1i, (_e3366 < f32(_e3373)))) + (_e3360 >> bitcast<u32>(31i))));
if ((_e3379 | _e3383) == 0u) {
} else {
let _e3386 = bitcast<u32>((_e3237 + 2i));
if (_e3386 < _e58) {
let _e3389 = atomicAdd((&global_2.member[_e3386]), _e3379);
phi_6053_ = _e3389;
} else {
phi_6053_ = 0u;
}
let _e3391 = phi_6053_;
let _e3395 = (_e3383 + select(0u, 1u, ((_e3391 + _e3379) < _e3379)));
if (_e3395 == 0u) {
} else {
let _e3397 = (_e3386 + 1u);
if (_e3397 < _e58) {
let _e3400 = atomicAdd((&global_2.member[_e3397]), _e3395);
}
}
}
}
}
phi_5690_ = (_e3143 + 1i);
} else {
phi_5690_ = i32();
}
let _e3403 = phi_5690_;
continue;
continuing {
phi_5689_ = _e3403;
break if !(_e3144);
}
}
phi_5607_ = (_e3095 + 1i);
} else {
phi_5607_ = i32();
}
let _e3407 = phi_5607_;
continue;
continuing {
phi_5606_ = _e3407;
break if !(_e3096);
}
}
} else {
if ((_e2608 > 0f) && (!(_e2663) || (_e2653 <= 2f))) {
let _e3424 = (1f / _e2608);
let _e3425 = ((((_e826 * _e2606) + (_e658 * _e1467)) + (_e742 * _e1468)) * _e3424);
let _e3426 = ((((_e836 * _e2606) + (_e668 * _e1467)) + (_e752 * _e1468)) * _e3424);
let _e3428 = select(_e237, _e3425, (_e3425 > _e237));
let _e3430 = select(65536f, _e3428, (_e3428 < 65536f));
let _e3437 = select(0i, select(select(i32(_e3430), i32(-2147483648), (_e3430 < -2147483600f)), 2147483647i, (_e3430 > 2147483500f)), (_e3430 == _e3430));
let _e3441 = (_e3437 - select(0i, 1i, (_e3430 < f32(_e3437))));
let _e3443 = select(_e237, _e3426, (_e3426 > _e237));
let _e3445 = select(65536f, _e3443, (_e3443 < 65536f));
let _e3452 = select(0i, select(select(i32(_e3445), i32(-2147483648), (_e3445 < -2147483600f)), 2147483647i, (_e3445 > 2147483500f)), (_e3445 == _e3445));
let _e3456 = (_e3452 - select(0i, 1i, (_e3445 < f32(_e3452))));
let _e3458 = (_e3425 - f32(_e3441));
let _e3460 = (_e3426 - f32(_e3456));
phi_6162_ = 0i;
loop {
let _e3462 = phi_6162_;
let _e3463 = (_e3462 < 4i);
if _e3463 {
let _e3464 = (_e3462 & 1i);
let _e3466 = (_e3462 >> bitcast<u32>(1i));
if (_e3464 == 0i) {
phi_6177_ = (1f - _e3458);
} else {
phi_6177_ = _e3458;
}
let _e3470 = phi_6177_;
if (_e3466 == 0i) {
phi_6183_ = (1f - _e3460);
} else {
phi_6183_ = _e3460;
}
let _e3474 = phi_6183_;
let _e3475 = (_e3441 + _e3464);
let _e3476 = (_e3456 + _e3466);
let _e3482 = global_1.member.member_10.member_15;
let _e3483 = bitcast<i32>(_e3482);
let _e3485 = (firstTrailingBit(8u) & 31u);
let _e3487 = (_e3475 >> bitcast<u32>(_e3485));
let _e3489 = (_e3476 >> bitcast<u32>(_e3485));
let _e3494 = global_1.member.member_10.member_14.member;
let _e3495 = bitcast<i32>(_e3494);
let _e3500 = global_1.member.member_10.member_14.member_1;
let _e3501 = bitcast<i32>(_e3500);
let _e3506 = global_1.member.member_10.member_14.member_2;
if ((((((_e3487 >= 0i) && (_e3487 < _e3495)) && (_e3489 >= 0i)) && (_e3489 < _e3501)) && (_e3483 >= 0i)) && (_e3483 < bitcast<i32>(_e3506))) {
phi_6239_ = (((((_e3483 * _e3501) + _e3489) * _e3495) + _e3487) * 3i);
} else {
phi_6239_ = -1i;
}
let _e3525 = phi_6239_;
let _e3526 = (_e3525 + 2i);
let _e3528 = (bitcast<i32>(_e55) - 1i);
let _e3530 = select(_e3528, _e3526, (_e3526 < _e3528));
let _e3535 = global_4.member[bitcast<u32>(select(0i, _e3530, (_e3530 > 0i)))];
let _e3536 = bitcast<i32>(_e3535);
let _e3547 = select(((((_e3536 - 1i) * 64i) + ((_e3476 & 7i) * 8i)) + (_e3475 & 7i)), -1i, ((_e3525 < 0i) || (_e3536 == 0i)));
let _e3551 = global_1.member.member_10.member_20;
let _e3552 = (_e3551 * ((1f * _e3470) * _e3474));
if ((_e3547 >= 0i) && (_e3552 > 0f)) {
let _e3556 = (_e3547 * 6i);
let _e3558 = ((_e2629 * _e3552) + 0.5f);
let _e3560 = select(-1073741800f, _e3558, (_e3558 > -1073741800f));
let _e3562 = select(1073741800f, _e3560, (_e3560 < 1073741800f));
let _e3569 = select(0i, select(select(i32(_e3562), i32(-2147483648), (_e3562 < -2147483600f)), 2147483647i, (_e3562 > 2147483500f)), (_e3562 == _e3562));
let _e3573 = (_e3569 - select(0i, 1i, (_e3562 < f32(_e3569))));
let _e3578 = (((_e74.member_2 == 3u) || (_e74.member_2 == 4u)) || (_e74.member_2 == 5u));
if _e3578 {
phi_6347_ = 0i;
} else {
let _e3580 = ((_e2630 * _e3552) + 0.5f);
let _e3582 = select(-1073741800f, _e3580, (_e3580 > -1073741800f));
let _e3584 = select(1073741800f, _e3582, (_e3582 < 1073741800f));
let _e3591 = select(0i, select(select(i32(_e3584), i32(-2147483648), (_e3584 < -2147483600f)), 2147483647i, (_e3584 > 2147483500f)), (_e3584 == _e3584));
phi_6347_ = (_e3591 - select(0i, 1i, (_e3584 < f32(_e3591))));
}
let _e3597 = phi_6347_;
let _e3598 = bitcast<u32>(_e3573);
let _e3602 = bitcast<u32>((_e3597 + (_e3573 >> bitcast<u32>(31i))));
if ((_e3598 | _e3602) == 0u) {
} else {
let _e3605 = bitcast<u32>(_e3556);
if (_e3605 < _e58) {
let _e3608 = atomicAdd((&global_2.member[_e3605]), _e3598);
phi_6366_ = _e3608;
} else {
phi_6366_ = 0u;
}
let _e3610 = phi_6366_;
let _e3614 = (_e3602 + select(0u, 1u, ((_e3610 + _e3598) < _e3598)));
if (_e3614 == 0u) {
} else {
let _e3616 = (_e3605 + 1u);
if (_e3616 < _e58) {
let _e3619 = atomicAdd((&global_2.member[_e3616]), _e3614);
}
}
}
if _e3578 {
} else {
let _e3622 = ((_e2631 * _e3552) + 0.5f);
let _e3624 = select(-1073741800f, _e3622, (_e3622 > -1073741800f));
let _e3626 = select(1073741800f, _e3624, (_e3624 < 1073741800f));
let _e3633 = select(0i, select(select(i32(_e3626), i32(-2147483648), (_e3626 < -2147483600f)), 2147483647i, (_e3626 > 2147483500f)), (_e3626 == _e3626));
let _e3637 = (_e3633 - select(0i, 1i, (_e3626 < f32(_e3633))));
let _e3638 = bitcast<u32>(_e3637);
let _e3641 = bitcast<u32>((_e3637 >> bitcast<u32>(31i)));
if ((_e3638 | _e3641) == 0u) {
} else {
let _e3644 = bitcast<u32>((_e3556 + 4i));
if (_e3644 < _e58) {
let _e3647 = atomicAdd((&global_2.member[_e3644]), _e3638);
phi_6434_ = _e3647;
} else {
phi_6434_ = 0u;
}
let _e3649 = phi_6434_;
let _e3653 = (_e3641 + select(0u, 1u, ((_e3649 + _e3638) < _e3638)));
if (_e3653 == 0u) {
} else {
let _e3655 = (_e3644 + 1u);
if (_e3655 < _e58) {
let _e3658 = atomicAdd((&global_2.member[_e3655]), _e3653);
}
}
}
}
let _e3661 = global_1.member.member_20;
if (_e3661 > 0f) {
let _e3664 = ((_e2632 * _e3552) + 0.5f);
let _e3666 = select(-1073741800f, _e3664, (_e3664 > -1073741800f));
let _e3668 = select(1073741800f, _e3666, (_e3666 < 1073741800f));
let _e3675 = select(0i, select(select(i32(_e3668), i32(-2147483648), (_e3668 < -2147483600f)), 2147483647i, (_e3668 > 2147483500f)), (_e3668 == _e3668));
let _e3679 = (_e3675 - select(0i, 1i, (_e3668 < f32(_e3675))));
let _e3681 = ((_e2633 * _e3552) + 0.5f);
let _e3683 = select(-1073741800f, _e3681, (_e3681 > -1073741800f));
let _e3685 = select(1073741800f, _e3683, (_e3683 < 1073741800f));
let _e3692 = select(0i, select(select(i32(_e3685), i32(-2147483648), (_e3685 < -2147483600f)), 2147483647i, (_e3685 > 2147483500f)), (_e3685 == _e3685));
let _e3698 = bitcast<u32>(_e3679);
let _e3702 = bitcast<u32>(((_e3692 - select(0i, 1i, (_e3685 < f32(_e3692)))) + (_e3679 >> bitcast<u32>(31i))));
if ((_e3698 | _e3702) == 0u) {
} else {
let _e3705 = bitcast<u32>((_e3556 + 2i));
if (_e3705 < _e58) {
let _e3708 = atomicAdd((&global_2.member[_e3705]), _e3698);
phi_6526_ = _e3708;
} else {
phi_6526_ = 0u;
}
let _e3710 = phi_6526_;
let _e3714 = (_e3702 + select(0u, 1u, ((_e3710 + _e3698) < _e3698)));
if (_e3714 == 0u) {
} else {
let _e3716 = (_e3705 + 1u);
if (_e3716 < _e58) {
let _e3719 = atomicAdd((&global_2.member[_e3716]), _e3714);
}
}
}
}
}
phi_6163_ = (_e3462 + 1i);
} else {
phi_6163_ = i32();
}
let _e3722 = phi_6163_;
continue;
continuing {
phi_6162_ = _e3722;
break if !(_e3463);
}
}
}
}
}
}
}
}
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
