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
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_3911_: type_29;
var phi_4673_: type_30;
var phi_5658_: type_5;
var phi_6682_: f32;
var phi_6683_: f32;
var phi_6684_: f32;
var phi_6685_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e95 = arrayLength((&global_4.member));
let _e102 = global_1.member.member_2;
let _e105 = global_1.member.member;
let _e113 = (_e88.x + _e102.member);
let _e115 = (_e88.y + _e102.member_1);
if (_e113 < _e102.member_2) {
if (_e115 < _e102.member_3) {
let _e118 = (_e105.member * _e105.member_1);
let _e120 = ((_e115 * _e105.member) + _e113);
let _e121 = bitcast<i32>(_e120);
let _e123 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e125 = select(_e123, _e121, (_e121 < _e123));
let _e131 = global_6.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e132 = (_e118 + _e120);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e123, _e133, (_e133 < _e123));
let _e141 = global_6.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((2u * _e118) + _e120);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e123, _e144, (_e144 < _e123));
let _e152 = global_6.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((3u * _e118) + _e120);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e123, _e155, (_e155 < _e123));
let _e163 = global_6.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((4u * _e118) + _e120);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e123, _e166, (_e166 < _e123));
let _e174 = global_6.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((5u * _e118) + _e120);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e123, _e177, (_e177 < _e123));
let _e185 = global_6.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((6u * _e118) + _e120);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e123, _e188, (_e188 < _e123));
let _e196 = global_6.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((7u * _e118) + _e120);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e123, _e199, (_e199 < _e123));
let _e207 = global_6.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((8u * _e118) + _e120);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e123, _e210, (_e210 < _e123));
let _e218 = global_6.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((9u * _e118) + _e120);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e123, _e221, (_e221 < _e123));
let _e229 = global_6.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((10u * _e118) + _e120);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e123, _e232, (_e232 < _e123));
let _e240 = global_6.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e244 = global_1.member.member_5.member_2;
let _e247 = (1f / select(1e-6f, _e196, (_e196 > 1e-6f)));
let _e251 = global_1.member.member_8.member_5;
let _e252 = (_e244 * _e251);
let _e257 = global_1.member.member_8.member_6;
let _e259 = (((_e174 * _e247) - _e257) * _e252);
let _e264 = global_1.member.member_8.member_7;
let _e266 = (((_e185 * _e247) - _e264) * _e252);
let _e270 = ((f32(bitcast<i32>(_e113)) - 0.5f) + _e131);
let _e274 = global_1.member.member_8.member_1;
let _e275 = (_e274 + 1u);
let _e277 = select(1u, _e275, (_e275 > 0u));
let _e278 = (_e277 == 0u);
if _e278 {
break;
}
let _e283 = ((f32(bitcast<i32>((_e115 % _e277))) - 0.5f) + _e141);
let _e287 = global_1.member.member_5.member;
let _e291 = global_1.member.member_8.member_8;
let _e292 = (_e287 - _e291);
let _e296 = global_1.member.member_8.member_2;
let _e303 = global_1.member.member_8.member_4;
let _e305 = ((_e296 + (_e257 * _e292)) + ((_e270 + 0.5f) * _e303));
let _e309 = global_1.member.member_8.member_3;
let _e314 = ((_e309 + (_e264 * _e292)) + ((_e283 + 0.5f) * _e303));
let _e320 = global_1.member.member_5.member_1;
let _e321 = (_e320 - _e291);
let _e326 = ((_e296 + (_e257 * _e321)) + (((_e270 + _e259) + 0.5f) * _e303));
let _e331 = ((_e309 + (_e264 * _e321)) + (((_e283 + _e266) + 0.5f) * _e303));
if _e278 {
break;
}
let _e334 = bitcast<i32>(((_e115 / _e277) * 3u));
let _e336 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e338 = select(_e336, _e334, (_e334 < _e336));
let _e344 = global_5.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e345 = (_e334 + 1i);
let _e347 = select(_e336, _e345, (_e345 < _e336));
let _e353 = global_5.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e354 = (_e334 + 2i);
let _e356 = select(_e336, _e354, (_e354 < _e336));
let _e362 = global_5.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e365 = (1f / select(1e-6f, _e362, (_e362 > 1e-6f)));
let _e368 = (((_e344 * _e365) - _e257) * _e252);
let _e371 = (((_e353 * _e365) - _e264) * _e252);
let _e383 = global_1.member.member_6.member;
let _e394 = ((((_e383.member.member * _e305) + (_e383.member.member_1 * _e314)) + (_e383.member.member_2 * _e287)) + _e383.member_1);
let _e398 = global_1.member.member_6.member_1;
let _e409 = ((((_e398.member.member * _e305) + (_e398.member.member_1 * _e314)) + (_e398.member.member_2 * _e287)) + _e398.member_1);
let _e413 = global_1.member.member_6.member_2;
let _e424 = ((((_e413.member.member * _e305) + (_e413.member.member_1 * _e314)) + (_e413.member.member_2 * _e287)) + _e413.member_1);
let _e430 = ((((_e383.member.member * _e326) + (_e383.member.member_1 * _e331)) + (_e383.member.member_2 * _e320)) + _e383.member_1);
let _e436 = ((((_e398.member.member * _e326) + (_e398.member.member_1 * _e331)) + (_e398.member.member_2 * _e320)) + _e398.member_1);
let _e442 = ((((_e413.member.member * _e326) + (_e413.member.member_1 * _e331)) + (_e413.member.member_2 * _e320)) + _e413.member_1);
let _e446 = global_1.member.member_6.member_4;
let _e451 = global_1.member.member_6.member_3.member;
let _e452 = (_e451 - 0.5f);
let _e454 = select(-0.5f, _e430, (_e430 > -0.5f));
let _e456 = select(_e452, _e454, (_e454 < _e452));
let _e461 = global_1.member.member_6.member_3.member_1;
let _e462 = (_e461 - 0.5f);
let _e464 = select(-0.5f, _e436, (_e436 > -0.5f));
let _e466 = select(_e462, _e464, (_e464 < _e462));
let _e471 = global_1.member.member_6.member_3.member_2;
let _e472 = (_e471 - 0.5f);
let _e474 = select(-0.5f, _e442, (_e442 > -0.5f));
let _e476 = select(_e472, _e474, (_e474 < _e472));
let _e477 = (_e430 - _e394);
let _e478 = (_e436 - _e409);
let _e479 = (_e442 - _e424);
let _e482 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
let _e485 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
let _e487 = select(_e485, _e482, (_e482 > _e485));
let _e490 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
let _e499 = bitcast<f32>((bitcast<u32>((_e430 - _e456)) & 2147483647u));
let _e502 = bitcast<f32>((bitcast<u32>((_e436 - _e466)) & 2147483647u));
let _e504 = select(_e502, _e499, (_e499 > _e502));
let _e507 = bitcast<f32>((bitcast<u32>((_e442 - _e476)) & 2147483647u));
let _e511 = (_e456 + 0.5f);
let _e512 = (_e451 - 1f);
let _e514 = select(0f, _e511, (_e511 > 0f));
let _e516 = select(_e512, _e514, (_e514 < _e512));
let _e523 = select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < -2147483600f)), 2147483647i, (_e516 > 2147483500f)), (_e516 == _e516));
let _e531 = global_1.member.member_6.member_12;
let _e532 = (_e531 & 31u);
let _e535 = (_e466 + 0.5f);
let _e536 = (_e461 - 1f);
let _e538 = select(0f, _e535, (_e535 > 0f));
let _e540 = select(_e536, _e538, (_e538 < _e536));
let _e547 = select(0i, select(select(i32(_e540), i32(-2147483648), (_e540 < -2147483600f)), 2147483647i, (_e540 > 2147483500f)), (_e540 == _e540));
let _e554 = (_e476 + 0.5f);
let _e555 = (_e471 - 1f);
let _e557 = select(0f, _e554, (_e554 > 0f));
let _e559 = select(_e555, _e557, (_e557 < _e555));
let _e566 = select(0i, select(select(i32(_e559), i32(-2147483648), (_e559 < -2147483600f)), 2147483647i, (_e559 > 2147483500f)), (_e559 == _e559));
let _e577 = global_1.member.member_6.member_9.member;
let _e583 = global_1.member.member_6.member_9.member_1;
let _e588 = global_1.member.member_6.member_10;
let _e594 = ((bitcast<i32>(_e588) + ((_e523 - select(0i, 1i, (_e516 < f32(_e523)))) >> bitcast<u32>(_e532))) + (bitcast<i32>(_e577) * (((_e547 - select(0i, 1i, (_e540 < f32(_e547)))) >> bitcast<u32>(_e532)) + (bitcast<i32>(_e583) * ((_e566 - select(0i, 1i, (_e559 < f32(_e566)))) >> bitcast<u32>(_e532))))));
let _e596 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e598 = select(_e596, _e594, (_e594 < _e596));
let _e604 = global_3.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e610 = global_1.member.member_1;
let _e617 = (((_e610 & 64u) != 0u) || ((((select(_e490, _e487, (_e487 > _e490)) <= _e446) && ((select(_e507, _e504, (_e504 > _e507)) > _e446) || (_e604 != 0u))) && true) && ((_e610 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e259 == 0f) && (_e266 == 0f)) && (_e368 == 0f)) && (_e371 == 0f))), _e617), (_e240 == 0f)) > 1u) {
if _e278 {
break;
}
if _e278 {
break;
}
let _e624 = (_e105.member_2 == 2u);
let _e627 = (((_e105.member_2 == 1u) || _e624) || (_e105.member_2 == 5u));
if _e627 {
let _e629 = select(-1f, _e456, (_e456 > -1f));
let _e631 = select(_e451, _e629, (_e629 < _e451));
let _e638 = select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < -2147483600f)), 2147483647i, (_e631 > 2147483500f)), (_e631 == _e631));
let _e642 = (_e638 - select(0i, 1i, (_e631 < f32(_e638))));
let _e644 = select(-1f, _e466, (_e466 > -1f));
let _e646 = select(_e461, _e644, (_e644 < _e461));
let _e653 = select(0i, select(select(i32(_e646), i32(-2147483648), (_e646 < -2147483600f)), 2147483647i, (_e646 > 2147483500f)), (_e646 == _e646));
let _e657 = (_e653 - select(0i, 1i, (_e646 < f32(_e653))));
let _e659 = select(-1f, _e476, (_e476 > -1f));
let _e661 = select(_e471, _e659, (_e659 < _e471));
let _e668 = select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < -2147483600f)), 2147483647i, (_e661 > 2147483500f)), (_e661 == _e661));
let _e672 = (_e668 - select(0i, 1i, (_e661 < f32(_e668))));
let _e676 = global_1.member.member_6.member_7;
let _e680 = global_1.member.member_6.member_8;
let _e688 = (select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461)) - 1i);
let _e689 = (_e657 - 1i);
let _e694 = (_e657 + 1i);
let _e697 = (_e657 + 2i);
let _e707 = (select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < -2147483600f)), 2147483647i, (_e471 > 2147483500f)), (_e471 == _e471)) - 1i);
let _e708 = (_e672 - 1i);
let _e713 = (_e672 + 1i);
let _e716 = (_e672 + 2i);
let _e725 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < -2147483600f)), 2147483647i, (_e451 > 2147483500f)), (_e451 == _e451));
let _e726 = (_e725 - 1i);
let _e727 = (_e642 - 1i);
let _e729 = select(0i, _e727, (_e727 > 0i));
let _e732 = (_e642 + 1i);
let _e735 = (_e642 + 2i);
let _e738 = (_e725 - 4i);
let _e740 = select(0i, _e738, (_e738 > 0i));
let _e742 = select(_e740, _e729, (_e729 < _e740));
let _e755 = (select(0i, _e689, (_e689 > 0i)) * _e676);
let _e756 = (select(0i, _e657, (_e657 > 0i)) * _e676);
let _e757 = (select(_e688, _e694, (_e694 < _e688)) * _e676);
let _e758 = (select(_e688, _e697, (_e697 < _e688)) * _e676);
let _e759 = (select(0i, _e708, (_e708 > 0i)) * _e680);
let _e760 = (select(0i, _e672, (_e672 > 0i)) * _e680);
let _e761 = (select(_e707, _e713, (_e713 < _e707)) * _e680);
let _e762 = (select(_e707, _e716, (_e716 < _e707)) * _e680);
local_4 = type_28(array<i32, 4>(_e742, _e742, _e742, _e742), array<u32, 6>(bitcast<u32>(((_e729 - _e742) * 8i)), bitcast<u32>(((select(0i, _e642, (_e642 > 0i)) - _e742) * 8i)), bitcast<u32>(((select(_e726, _e732, (_e732 < _e726)) - _e742) * 8i)), bitcast<u32>(((select(_e726, _e735, (_e735 < _e726)) - _e742) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e456 - f32(_e642)), (_e466 - f32(_e657)), (_e476 - f32(_e672)));
let _e777 = local_4.member[0u];
let _e778 = ((_e760 + _e756) + _e777);
let _e780 = (_e778 >> bitcast<u32>(2i));
let _e783 = bitcast<u32>(((_e778 & 3i) * 8i));
let _e785 = (bitcast<i32>(_e91) - 1i);
let _e787 = select(_e785, _e780, (_e780 < _e785));
let _e792 = global_2.member[bitcast<u32>(select(0i, _e787, (_e787 > 0i)))];
let _e796 = (_e780 + 1i);
let _e798 = select(_e785, _e796, (_e796 < _e785));
let _e803 = global_2.member[bitcast<u32>(select(0i, _e798, (_e798 > 0i)))];
let _e810 = ((_e792 >> bitcast<u32>((_e783 & 31u))) | ((_e803 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e783) & 31u))));
let _e813 = local_4.member_1[0u];
let _e819 = f32(bitcast<i32>(((_e810 >> bitcast<u32>((_e813 & 31u))) & 255u)));
let _e822 = local_4.member_1[1u];
let _e828 = f32(bitcast<i32>(((_e810 >> bitcast<u32>((_e822 & 31u))) & 255u)));
let _e831 = local_4.member_1[2u];
let _e837 = f32(bitcast<i32>(((_e810 >> bitcast<u32>((_e831 & 31u))) & 255u)));
let _e840 = local_4.member_1[3u];
let _e847 = local_5[0u];
let _e850 = (_e819 + ((_e828 - _e819) * _e847));
let _e851 = local_5[0u];
let _e854 = (_e828 + ((_e837 - _e828) * _e851));
let _e855 = local_5[0u];
let _e858 = (_e837 + ((f32(bitcast<i32>(((_e810 >> bitcast<u32>((_e840 & 31u))) & 255u))) - _e837) * _e855));
let _e860 = local_4.member[0u];
let _e861 = ((_e760 + _e757) + _e860);
let _e863 = (_e861 >> bitcast<u32>(2i));
let _e866 = bitcast<u32>(((_e861 & 3i) * 8i));
let _e868 = select(_e785, _e863, (_e863 < _e785));
let _e873 = global_2.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
let _e877 = (_e863 + 1i);
let _e879 = select(_e785, _e877, (_e877 < _e785));
let _e884 = global_2.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e891 = ((_e873 >> bitcast<u32>((_e866 & 31u))) | ((_e884 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e866) & 31u))));
let _e892 = local_4.member_1[0u];
let _e898 = f32(bitcast<i32>(((_e891 >> bitcast<u32>((_e892 & 31u))) & 255u)));
let _e899 = local_4.member_1[1u];
let _e905 = f32(bitcast<i32>(((_e891 >> bitcast<u32>((_e899 & 31u))) & 255u)));
let _e906 = local_4.member_1[2u];
let _e912 = f32(bitcast<i32>(((_e891 >> bitcast<u32>((_e906 & 31u))) & 255u)));
let _e913 = local_4.member_1[3u];
let _e920 = local_5[0u];
let _e924 = local_5[0u];
let _e927 = (_e905 + ((_e912 - _e905) * _e924));
let _e928 = local_5[0u];
let _e933 = local_4.member[0u];
let _e934 = ((_e761 + _e756) + _e933);
let _e936 = (_e934 >> bitcast<u32>(2i));
let _e939 = bitcast<u32>(((_e934 & 3i) * 8i));
let _e941 = select(_e785, _e936, (_e936 < _e785));
let _e946 = global_2.member[bitcast<u32>(select(0i, _e941, (_e941 > 0i)))];
let _e950 = (_e936 + 1i);
let _e952 = select(_e785, _e950, (_e950 < _e785));
let _e957 = global_2.member[bitcast<u32>(select(0i, _e952, (_e952 > 0i)))];
let _e964 = ((_e946 >> bitcast<u32>((_e939 & 31u))) | ((_e957 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e939) & 31u))));
let _e965 = local_4.member_1[0u];
let _e971 = f32(bitcast<i32>(((_e964 >> bitcast<u32>((_e965 & 31u))) & 255u)));
let _e972 = local_4.member_1[1u];
let _e978 = f32(bitcast<i32>(((_e964 >> bitcast<u32>((_e972 & 31u))) & 255u)));
let _e979 = local_4.member_1[2u];
let _e985 = f32(bitcast<i32>(((_e964 >> bitcast<u32>((_e979 & 31u))) & 255u)));
let _e986 = local_4.member_1[3u];
let _e993 = local_5[0u];
let _e996 = (_e971 + ((_e978 - _e971) * _e993));
let _e997 = local_5[0u];
let _e1000 = (_e978 + ((_e985 - _e978) * _e997));
let _e1001 = local_5[0u];
let _e1004 = (_e985 + ((f32(bitcast<i32>(((_e964 >> bitcast<u32>((_e986 & 31u))) & 255u))) - _e985) * _e1001));
let _e1006 = local_4.member[0u];
let _e1007 = ((_e761 + _e757) + _e1006);
let _e1009 = (_e1007 >> bitcast<u32>(2i));
let _e1012 = bitcast<u32>(((_e1007 & 3i) * 8i));
let _e1014 = select(_e785, _e1009, (_e1009 < _e785));
let _e1019 = global_2.member[bitcast<u32>(select(0i, _e1014, (_e1014 > 0i)))];
let _e1023 = (_e1009 + 1i);
let _e1025 = select(_e785, _e1023, (_e1023 < _e785));
let _e1030 = global_2.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1037 = ((_e1019 >> bitcast<u32>((_e1012 & 31u))) | ((_e1030 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1012) & 31u))));
let _e1038 = local_4.member_1[0u];
let _e1044 = f32(bitcast<i32>(((_e1037 >> bitcast<u32>((_e1038 & 31u))) & 255u)));
let _e1045 = local_4.member_1[1u];
let _e1051 = f32(bitcast<i32>(((_e1037 >> bitcast<u32>((_e1045 & 31u))) & 255u)));
let _e1052 = local_4.member_1[2u];
let _e1058 = f32(bitcast<i32>(((_e1037 >> bitcast<u32>((_e1052 & 31u))) & 255u)));
let _e1059 = local_4.member_1[3u];
let _e1066 = local_5[0u];
let _e1070 = local_5[0u];
let _e1073 = (_e1051 + ((_e1058 - _e1051) * _e1070));
let _e1074 = local_5[0u];
let _e1079 = local_4.member[0u];
let _e1080 = ((_e760 + _e755) + _e1079);
let _e1082 = (_e1080 >> bitcast<u32>(2i));
let _e1085 = bitcast<u32>(((_e1080 & 3i) * 8i));
let _e1087 = select(_e785, _e1082, (_e1082 < _e785));
let _e1092 = global_2.member[bitcast<u32>(select(0i, _e1087, (_e1087 > 0i)))];
let _e1096 = (_e1082 + 1i);
let _e1098 = select(_e785, _e1096, (_e1096 < _e785));
let _e1103 = global_2.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1110 = ((_e1092 >> bitcast<u32>((_e1085 & 31u))) | ((_e1103 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1085) & 31u))));
let _e1111 = local_4.member_1[1u];
let _e1117 = f32(bitcast<i32>(((_e1110 >> bitcast<u32>((_e1111 & 31u))) & 255u)));
let _e1118 = local_4.member_1[2u];
let _e1125 = local_5[0u];
let _e1128 = (_e1117 + ((f32(bitcast<i32>(((_e1110 >> bitcast<u32>((_e1118 & 31u))) & 255u))) - _e1117) * _e1125));
let _e1130 = local_4.member[0u];
let _e1131 = ((_e760 + _e758) + _e1130);
let _e1133 = (_e1131 >> bitcast<u32>(2i));
let _e1136 = bitcast<u32>(((_e1131 & 3i) * 8i));
let _e1138 = select(_e785, _e1133, (_e1133 < _e785));
let _e1143 = global_2.member[bitcast<u32>(select(0i, _e1138, (_e1138 > 0i)))];
let _e1147 = (_e1133 + 1i);
let _e1149 = select(_e785, _e1147, (_e1147 < _e785));
let _e1154 = global_2.member[bitcast<u32>(select(0i, _e1149, (_e1149 > 0i)))];
let _e1161 = ((_e1143 >> bitcast<u32>((_e1136 & 31u))) | ((_e1154 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1136) & 31u))));
let _e1162 = local_4.member_1[1u];
let _e1168 = f32(bitcast<i32>(((_e1161 >> bitcast<u32>((_e1162 & 31u))) & 255u)));
let _e1169 = local_4.member_1[2u];
let _e1176 = local_5[0u];
let _e1181 = local_4.member[0u];
let _e1182 = ((_e761 + _e755) + _e1181);
let _e1184 = (_e1182 >> bitcast<u32>(2i));
let _e1187 = bitcast<u32>(((_e1182 & 3i) * 8i));
let _e1189 = select(_e785, _e1184, (_e1184 < _e785));
let _e1194 = global_2.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1198 = (_e1184 + 1i);
let _e1200 = select(_e785, _e1198, (_e1198 < _e785));
let _e1205 = global_2.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1212 = ((_e1194 >> bitcast<u32>((_e1187 & 31u))) | ((_e1205 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1187) & 31u))));
let _e1213 = local_4.member_1[1u];
let _e1219 = f32(bitcast<i32>(((_e1212 >> bitcast<u32>((_e1213 & 31u))) & 255u)));
let _e1220 = local_4.member_1[2u];
let _e1227 = local_5[0u];
let _e1230 = (_e1219 + ((f32(bitcast<i32>(((_e1212 >> bitcast<u32>((_e1220 & 31u))) & 255u))) - _e1219) * _e1227));
let _e1232 = local_4.member[0u];
let _e1233 = ((_e761 + _e758) + _e1232);
let _e1235 = (_e1233 >> bitcast<u32>(2i));
let _e1238 = bitcast<u32>(((_e1233 & 3i) * 8i));
let _e1240 = select(_e785, _e1235, (_e1235 < _e785));
let _e1245 = global_2.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1249 = (_e1235 + 1i);
let _e1251 = select(_e785, _e1249, (_e1249 < _e785));
let _e1256 = global_2.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1263 = ((_e1245 >> bitcast<u32>((_e1238 & 31u))) | ((_e1256 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1238) & 31u))));
let _e1264 = local_4.member_1[1u];
let _e1270 = f32(bitcast<i32>(((_e1263 >> bitcast<u32>((_e1264 & 31u))) & 255u)));
let _e1271 = local_4.member_1[2u];
let _e1278 = local_5[0u];
let _e1283 = local_4.member[0u];
let _e1284 = ((_e759 + _e756) + _e1283);
let _e1286 = (_e1284 >> bitcast<u32>(2i));
let _e1289 = bitcast<u32>(((_e1284 & 3i) * 8i));
let _e1291 = select(_e785, _e1286, (_e1286 < _e785));
let _e1296 = global_2.member[bitcast<u32>(select(0i, _e1291, (_e1291 > 0i)))];
let _e1300 = (_e1286 + 1i);
let _e1302 = select(_e785, _e1300, (_e1300 < _e785));
let _e1307 = global_2.member[bitcast<u32>(select(0i, _e1302, (_e1302 > 0i)))];
let _e1314 = ((_e1296 >> bitcast<u32>((_e1289 & 31u))) | ((_e1307 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1289) & 31u))));
let _e1315 = local_4.member_1[1u];
let _e1321 = f32(bitcast<i32>(((_e1314 >> bitcast<u32>((_e1315 & 31u))) & 255u)));
let _e1322 = local_4.member_1[2u];
let _e1329 = local_5[0u];
let _e1332 = (_e1321 + ((f32(bitcast<i32>(((_e1314 >> bitcast<u32>((_e1322 & 31u))) & 255u))) - _e1321) * _e1329));
let _e1334 = local_4.member[0u];
let _e1335 = ((_e762 + _e756) + _e1334);
let _e1337 = (_e1335 >> bitcast<u32>(2i));
let _e1340 = bitcast<u32>(((_e1335 & 3i) * 8i));
let _e1342 = select(_e785, _e1337, (_e1337 < _e785));
let _e1347 = global_2.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1351 = (_e1337 + 1i);
let _e1353 = select(_e785, _e1351, (_e1351 < _e785));
let _e1358 = global_2.member[bitcast<u32>(select(0i, _e1353, (_e1353 > 0i)))];
let _e1365 = ((_e1347 >> bitcast<u32>((_e1340 & 31u))) | ((_e1358 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1340) & 31u))));
let _e1366 = local_4.member_1[1u];
let _e1372 = f32(bitcast<i32>(((_e1365 >> bitcast<u32>((_e1366 & 31u))) & 255u)));
let _e1373 = local_4.member_1[2u];
let _e1380 = local_5[0u];
let _e1383 = (_e1372 + ((f32(bitcast<i32>(((_e1365 >> bitcast<u32>((_e1373 & 31u))) & 255u))) - _e1372) * _e1380));
let _e1385 = local_4.member[0u];
let _e1386 = ((_e759 + _e757) + _e1385);
let _e1388 = (_e1386 >> bitcast<u32>(2i));
let _e1391 = bitcast<u32>(((_e1386 & 3i) * 8i));
let _e1393 = select(_e785, _e1388, (_e1388 < _e785));
let _e1398 = global_2.member[bitcast<u32>(select(0i, _e1393, (_e1393 > 0i)))];
let _e1402 = (_e1388 + 1i);
let _e1404 = select(_e785, _e1402, (_e1402 < _e785));
let _e1409 = global_2.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1416 = ((_e1398 >> bitcast<u32>((_e1391 & 31u))) | ((_e1409 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1391) & 31u))));
let _e1417 = local_4.member_1[1u];
let _e1423 = f32(bitcast<i32>(((_e1416 >> bitcast<u32>((_e1417 & 31u))) & 255u)));
let _e1424 = local_4.member_1[2u];
let _e1431 = local_5[0u];
let _e1436 = local_4.member[0u];
let _e1437 = ((_e762 + _e757) + _e1436);
let _e1439 = (_e1437 >> bitcast<u32>(2i));
let _e1442 = bitcast<u32>(((_e1437 & 3i) * 8i));
let _e1444 = select(_e785, _e1439, (_e1439 < _e785));
let _e1449 = global_2.member[bitcast<u32>(select(0i, _e1444, (_e1444 > 0i)))];
let _e1453 = (_e1439 + 1i);
let _e1455 = select(_e785, _e1453, (_e1453 < _e785));
let _e1460 = global_2.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1467 = ((_e1449 >> bitcast<u32>((_e1442 & 31u))) | ((_e1460 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1442) & 31u))));
let _e1468 = local_4.member_1[1u];
let _e1474 = f32(bitcast<i32>(((_e1467 >> bitcast<u32>((_e1468 & 31u))) & 255u)));
let _e1475 = local_4.member_1[2u];
let _e1482 = local_5[0u];
let _e1487 = local_5[1u];
let _e1490 = (_e854 + ((_e927 - _e854) * _e1487));
let _e1491 = local_5[1u];
let _e1494 = (_e1000 + ((_e1073 - _e1000) * _e1491));
let _e1495 = local_5[1u];
let _e1498 = (_e850 + (((_e898 + ((_e905 - _e898) * _e920)) - _e850) * _e1495));
let _e1499 = local_5[1u];
let _e1504 = local_5[2u];
let _e1508 = local_5[1u];
let _e1511 = (_e858 + (((_e912 + ((f32(bitcast<i32>(((_e891 >> bitcast<u32>((_e913 & 31u))) & 255u))) - _e912) * _e928)) - _e858) * _e1508));
let _e1512 = local_5[1u];
let _e1516 = local_5[2u];
let _e1520 = local_5[1u];
let _e1523 = (_e1128 + ((_e854 - _e1128) * _e1520));
let _e1524 = local_5[1u];
let _e1528 = local_5[2u];
let _e1532 = local_5[1u];
let _e1535 = (_e927 + (((_e1168 + ((f32(bitcast<i32>(((_e1161 >> bitcast<u32>((_e1169 & 31u))) & 255u))) - _e1168) * _e1176)) - _e927) * _e1532));
let _e1536 = local_5[1u];
let _e1540 = local_5[2u];
let _e1544 = local_5[1u];
let _e1547 = (_e1332 + (((_e1423 + ((f32(bitcast<i32>(((_e1416 >> bitcast<u32>((_e1424 & 31u))) & 255u))) - _e1423) * _e1431)) - _e1332) * _e1544));
let _e1548 = local_5[2u];
let _e1552 = local_5[1u];
let _e1556 = local_5[2u];
let _e1560 = local_5[2u];
let _e1567 = global_1.member.member_6.member_5;
let _e1572 = global_1.member.member_6.member_6;
let _e1573 = (((_e1490 + ((_e1494 - _e1490) * _e1560)) * _e1567) + _e1572);
let _e1575 = select(0f, _e1573, (_e1573 > 0f));
let _e1577 = select(1f, _e1575, (_e1575 < 1f));
let _e1579 = (((_e1498 + (((_e996 + (((_e1044 + ((_e1051 - _e1044) * _e1066)) - _e996) * _e1499)) - _e1498) * _e1504)) * _e1567) + _e1572);
let _e1581 = select(0f, _e1579, (_e1579 > 0f));
let _e1583 = select(1f, _e1581, (_e1581 < 1f));
let _e1585 = (((_e1511 + (((_e1004 + (((_e1058 + ((f32(bitcast<i32>(((_e1037 >> bitcast<u32>((_e1059 & 31u))) & 255u))) - _e1058) * _e1074)) - _e1004) * _e1512)) - _e1511) * _e1516)) * _e1567) + _e1572);
let _e1587 = select(0f, _e1585, (_e1585 > 0f));
let _e1589 = select(1f, _e1587, (_e1587 < 1f));
let _e1591 = (((_e1523 + (((_e1230 + ((_e1000 - _e1230) * _e1524)) - _e1523) * _e1528)) * _e1567) + _e1572);
let _e1593 = select(0f, _e1591, (_e1591 > 0f));
let _e1595 = select(1f, _e1593, (_e1593 < 1f));
let _e1597 = (((_e1535 + (((_e1073 + (((_e1270 + ((f32(bitcast<i32>(((_e1263 >> bitcast<u32>((_e1271 & 31u))) & 255u))) - _e1270) * _e1278)) - _e1073) * _e1536)) - _e1535) * _e1540)) * _e1567) + _e1572);
let _e1599 = select(0f, _e1597, (_e1597 > 0f));
let _e1601 = select(1f, _e1599, (_e1599 < 1f));
let _e1603 = (((_e1547 + ((_e1490 - _e1547) * _e1548)) * _e1567) + _e1572);
let _e1605 = select(0f, _e1603, (_e1603 > 0f));
let _e1607 = select(1f, _e1605, (_e1605 < 1f));
let _e1609 = (((_e1494 + (((_e1383 + (((_e1474 + ((f32(bitcast<i32>(((_e1467 >> bitcast<u32>((_e1475 & 31u))) & 255u))) - _e1474) * _e1482)) - _e1383) * _e1552)) - _e1494) * _e1556)) * _e1567) + _e1572);
let _e1611 = select(0f, _e1609, (_e1609 > 0f));
let _e1613 = select(1f, _e1611, (_e1611 < 1f));
let _e1614 = (_e1577 * 1024f);
let _e1615 = (1024f - 1f);
let _e1617 = select(0f, _e1614, (_e1614 > 0f));
let _e1619 = select(_e1615, _e1617, (_e1617 < _e1615));
let _e1626 = select(0i, select(select(i32(_e1619), i32(-2147483648), (_e1619 < -2147483600f)), 2147483647i, (_e1619 > 2147483500f)), (_e1619 == _e1619));
let _e1630 = (_e1626 - select(0i, 1i, (_e1619 < f32(_e1626))));
let _e1631 = (262147i + _e1630);
let _e1633 = (bitcast<i32>(_e95) - 1i);
let _e1635 = select(_e1633, _e1631, (_e1631 < _e1633));
let _e1641 = global_4.member[bitcast<u32>(select(0i, _e1635, (_e1635 > 0i)))];
let _e1651 = select(_e1633, 262146i, (262146i < _e1633));
let _e1657 = global_4.member[bitcast<u32>(select(0i, _e1651, (_e1651 > 0i)))];
let _e1658 = bitcast<f32>(_e1657);
let _e1659 = (f32((bitcast<i32>((_e1641 & 4095u)) - 2048i)) * _e1658);
let _e1661 = select(_e1633, 262144i, (262144i < _e1633));
let _e1667 = global_4.member[bitcast<u32>(select(0i, _e1661, (_e1661 > 0i)))];
let _e1668 = bitcast<f32>(_e1667);
let _e1670 = select(_e1633, 262145i, (262145i < _e1633));
let _e1676 = global_4.member[bitcast<u32>(select(0i, _e1670, (_e1670 > 0i)))];
let _e1677 = bitcast<f32>(_e1676);
let _e1683 = ((_e1668 + (f32(bitcast<i32>((_e1641 >> bitcast<u32>(12u)))) * _e1677)) + (_e1659 * (_e1614 - f32(_e1630))));
let _e1684 = (_e1659 * 1024f);
if _e624 {
let _e1691 = ((0.5f * (_e1589 - _e1583)) * _e1684);
let _e1692 = ((0.5f * (_e1601 - _e1595)) * _e1684);
let _e1693 = ((0.5f * (_e1613 - _e1607)) * _e1684);
phi_3911_ = type_29(_e1683, vec3<f32>(_e1691, _e1692, _e1693), vec3<f32>((_e1691 * _e1683), (_e1692 * _e1683), (_e1693 * _e1683)));
} else {
let _e1700 = (_e1583 * 1024f);
let _e1702 = select(0f, _e1700, (_e1700 > 0f));
let _e1704 = select(_e1615, _e1702, (_e1702 < _e1615));
let _e1711 = select(0i, select(select(i32(_e1704), i32(-2147483648), (_e1704 < -2147483600f)), 2147483647i, (_e1704 > 2147483500f)), (_e1704 == _e1704));
let _e1715 = (_e1711 - select(0i, 1i, (_e1704 < f32(_e1711))));
let _e1716 = (262147i + _e1715);
let _e1718 = select(_e1633, _e1716, (_e1716 < _e1633));
let _e1724 = global_4.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1739 = ((_e1668 + (f32(bitcast<i32>((_e1724 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1724 & 4095u)) - 2048i)) * _e1658) * (_e1700 - f32(_e1715))));
let _e1740 = (_e1589 * 1024f);
let _e1742 = select(0f, _e1740, (_e1740 > 0f));
let _e1744 = select(_e1615, _e1742, (_e1742 < _e1615));
let _e1751 = select(0i, select(select(i32(_e1744), i32(-2147483648), (_e1744 < -2147483600f)), 2147483647i, (_e1744 > 2147483500f)), (_e1744 == _e1744));
let _e1755 = (_e1751 - select(0i, 1i, (_e1744 < f32(_e1751))));
let _e1756 = (262147i + _e1755);
let _e1758 = select(_e1633, _e1756, (_e1756 < _e1633));
let _e1764 = global_4.member[bitcast<u32>(select(0i, _e1758, (_e1758 > 0i)))];
let _e1779 = ((_e1668 + (f32(bitcast<i32>((_e1764 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1764 & 4095u)) - 2048i)) * _e1658) * (_e1740 - f32(_e1755))));
let _e1780 = (_e1595 * 1024f);
let _e1782 = select(0f, _e1780, (_e1780 > 0f));
let _e1784 = select(_e1615, _e1782, (_e1782 < _e1615));
let _e1791 = select(0i, select(select(i32(_e1784), i32(-2147483648), (_e1784 < -2147483600f)), 2147483647i, (_e1784 > 2147483500f)), (_e1784 == _e1784));
let _e1795 = (_e1791 - select(0i, 1i, (_e1784 < f32(_e1791))));
let _e1796 = (262147i + _e1795);
let _e1798 = select(_e1633, _e1796, (_e1796 < _e1633));
let _e1804 = global_4.member[bitcast<u32>(select(0i, _e1798, (_e1798 > 0i)))];
let _e1819 = ((_e1668 + (f32(bitcast<i32>((_e1804 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1804 & 4095u)) - 2048i)) * _e1658) * (_e1780 - f32(_e1795))));
let _e1820 = (_e1601 * 1024f);
let _e1822 = select(0f, _e1820, (_e1820 > 0f));
let _e1824 = select(_e1615, _e1822, (_e1822 < _e1615));
let _e1831 = select(0i, select(select(i32(_e1824), i32(-2147483648), (_e1824 < -2147483600f)), 2147483647i, (_e1824 > 2147483500f)), (_e1824 == _e1824));
let _e1835 = (_e1831 - select(0i, 1i, (_e1824 < f32(_e1831))));
let _e1836 = (262147i + _e1835);
let _e1838 = select(_e1633, _e1836, (_e1836 < _e1633));
let _e1844 = global_4.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1859 = ((_e1668 + (f32(bitcast<i32>((_e1844 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1844 & 4095u)) - 2048i)) * _e1658) * (_e1820 - f32(_e1835))));
let _e1860 = (_e1607 * 1024f);
let _e1862 = select(0f, _e1860, (_e1860 > 0f));
let _e1864 = select(_e1615, _e1862, (_e1862 < _e1615));
let _e1871 = select(0i, select(select(i32(_e1864), i32(-2147483648), (_e1864 < -2147483600f)), 2147483647i, (_e1864 > 2147483500f)), (_e1864 == _e1864));
let _e1875 = (_e1871 - select(0i, 1i, (_e1864 < f32(_e1871))));
let _e1876 = (262147i + _e1875);
let _e1878 = select(_e1633, _e1876, (_e1876 < _e1633));
let _e1884 = global_4.member[bitcast<u32>(select(0i, _e1878, (_e1878 > 0i)))];
let _e1899 = ((_e1668 + (f32(bitcast<i32>((_e1884 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1884 & 4095u)) - 2048i)) * _e1658) * (_e1860 - f32(_e1875))));
let _e1900 = (_e1613 * 1024f);
let _e1902 = select(0f, _e1900, (_e1900 > 0f));
let _e1904 = select(_e1615, _e1902, (_e1902 < _e1615));
let _e1911 = select(0i, select(select(i32(_e1904), i32(-2147483648), (_e1904 < -2147483600f)), 2147483647i, (_e1904 > 2147483500f)), (_e1904 == _e1904));
let _e1915 = (_e1911 - select(0i, 1i, (_e1904 < f32(_e1911))));
let _e1916 = (262147i + _e1915);
let _e1918 = select(_e1633, _e1916, (_e1916 < _e1633));
let _e1924 = global_4.member[bitcast<u32>(select(0i, _e1918, (_e1918 > 0i)))];
let _e1939 = ((_e1668 + (f32(bitcast<i32>((_e1924 >> bitcast<u32>(12u)))) * _e1677)) + ((f32((bitcast<i32>((_e1924 & 4095u)) - 2048i)) * _e1658) * (_e1900 - f32(_e1915))));
let _e1940 = (_e1779 - _e1739);
let _e1942 = (_e1859 - _e1819);
let _e1944 = (_e1939 - _e1899);
phi_3911_ = type_29(_e1683, vec3<f32>((0.5f * _e1940), (0.5f * _e1942), (0.5f * _e1944)), vec3<f32>((0.25f * (_e1940 * (_e1779 + _e1739))), (0.25f * (_e1942 * (_e1859 + _e1819))), (0.25f * (_e1944 * (_e1939 + _e1899)))));
}
let _e1959 = phi_3911_;
let _e1974 = select(0f, 1f, ((((((_e430 >= -0.5f) && (_e430 <= _e452)) && (_e436 >= -0.5f)) && (_e436 <= _e462)) && (_e442 >= -0.5f)) && (_e442 <= _e472)));
let _e1976 = (0.5f * (_e1589 - _e1583));
let _e1978 = (0.5f * (_e1601 - _e1595));
let _e1980 = (0.5f * (_e1613 - _e1607));
let _e1986 = global_1.member.member_6.member.member.member;
let _e1992 = global_1.member.member_6.member.member.member_1;
let _e1998 = global_1.member.member_6.member.member.member_2;
let _e2004 = global_1.member.member_6.member_1.member.member;
let _e2010 = global_1.member.member_6.member_1.member.member_1;
let _e2016 = global_1.member.member_6.member_1.member.member_2;
let _e2022 = global_1.member.member_6.member_2.member.member;
let _e2028 = global_1.member.member_6.member_2.member.member_1;
let _e2034 = global_1.member.member_6.member_2.member.member_2;
phi_4673_ = type_30(_e1577, vec3<f32>(((((_e1986 * _e1976) + (_e2004 * _e1978)) + (_e2022 * _e1980)) * _e1974), ((((_e1992 * _e1976) + (_e2010 * _e1978)) + (_e2028 * _e1980)) * _e1974), ((((_e1998 * _e1976) + (_e2016 * _e1978)) + (_e2034 * _e1980)) * _e1974)), _e1959.member, vec3<f32>(((((_e1986 * _e1959.member_2.x) + (_e2004 * _e1959.member_2.y)) + (_e2022 * _e1959.member_2.z)) * _e1974), ((((_e1992 * _e1959.member_2.x) + (_e2010 * _e1959.member_2.y)) + (_e2028 * _e1959.member_2.z)) * _e1974), ((((_e1998 * _e1959.member_2.x) + (_e2016 * _e1959.member_2.y)) + (_e2034 * _e1959.member_2.z)) * _e1974)), vec3<f32>(((((_e1986 * _e1959.member_1.x) + (_e2004 * _e1959.member_1.y)) + (_e2022 * _e1959.member_1.z)) * _e1974), ((((_e1992 * _e1959.member_1.x) + (_e2010 * _e1959.member_1.y)) + (_e2028 * _e1959.member_1.z)) * _e1974), ((((_e1998 * _e1959.member_1.x) + (_e2016 * _e1959.member_1.y)) + (_e2034 * _e1959.member_1.z)) * _e1974)));
} else {
let _e2100 = select(-1f, _e456, (_e456 > -1f));
let _e2102 = select(_e451, _e2100, (_e2100 < _e451));
let _e2109 = select(0i, select(select(i32(_e2102), i32(-2147483648), (_e2102 < -2147483600f)), 2147483647i, (_e2102 > 2147483500f)), (_e2102 == _e2102));
let _e2113 = (_e2109 - select(0i, 1i, (_e2102 < f32(_e2109))));
let _e2115 = select(-1f, _e466, (_e466 > -1f));
let _e2117 = select(_e461, _e2115, (_e2115 < _e461));
let _e2124 = select(0i, select(select(i32(_e2117), i32(-2147483648), (_e2117 < -2147483600f)), 2147483647i, (_e2117 > 2147483500f)), (_e2117 == _e2117));
let _e2128 = (_e2124 - select(0i, 1i, (_e2117 < f32(_e2124))));
let _e2130 = select(-1f, _e476, (_e476 > -1f));
let _e2132 = select(_e471, _e2130, (_e2130 < _e471));
let _e2139 = select(0i, select(select(i32(_e2132), i32(-2147483648), (_e2132 < -2147483600f)), 2147483647i, (_e2132 > 2147483500f)), (_e2132 == _e2132));
let _e2143 = (_e2139 - select(0i, 1i, (_e2132 < f32(_e2139))));
let _e2147 = global_1.member.member_6.member_7;
let _e2151 = global_1.member.member_6.member_8;
let _e2159 = (select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461)) - 1i);
let _e2162 = (_e2128 + 1i);
let _e2172 = (select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < -2147483600f)), 2147483647i, (_e471 > 2147483500f)), (_e471 == _e471)) - 1i);
let _e2175 = (_e2143 + 1i);
let _e2184 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < -2147483600f)), 2147483647i, (_e451 > 2147483500f)), (_e451 == _e451));
let _e2185 = (_e2184 - 1i);
let _e2186 = (_e2113 - 1i);
let _e2188 = select(0i, _e2186, (_e2186 > 0i));
let _e2191 = (_e2113 + 1i);
let _e2194 = (_e2113 + 2i);
let _e2197 = (_e2184 - 4i);
let _e2199 = select(0i, _e2197, (_e2197 > 0i));
let _e2201 = select(_e2199, _e2188, (_e2188 < _e2199));
let _e2214 = (select(0i, _e2128, (_e2128 > 0i)) * _e2147);
let _e2215 = (select(_e2159, _e2162, (_e2162 < _e2159)) * _e2147);
let _e2216 = (select(0i, _e2143, (_e2143 > 0i)) * _e2151);
let _e2217 = (select(_e2172, _e2175, (_e2175 < _e2172)) * _e2151);
local_2 = type_28(array<i32, 4>(_e2201, _e2201, _e2201, _e2201), array<u32, 6>(bitcast<u32>(((_e2188 - _e2201) * 8i)), bitcast<u32>(((select(0i, _e2113, (_e2113 > 0i)) - _e2201) * 8i)), bitcast<u32>(((select(_e2185, _e2191, (_e2191 < _e2185)) - _e2201) * 8i)), bitcast<u32>(((select(_e2185, _e2194, (_e2194 < _e2185)) - _e2201) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e456 - f32(_e2113)), (_e466 - f32(_e2128)), (_e476 - f32(_e2143)));
let _e2232 = local_2.member[0u];
let _e2233 = ((_e2216 + _e2214) + _e2232);
let _e2235 = (_e2233 >> bitcast<u32>(2i));
let _e2238 = bitcast<u32>(((_e2233 & 3i) * 8i));
let _e2240 = (bitcast<i32>(_e91) - 1i);
let _e2242 = select(_e2240, _e2235, (_e2235 < _e2240));
let _e2247 = global_2.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2251 = (_e2235 + 1i);
let _e2253 = select(_e2240, _e2251, (_e2251 < _e2240));
let _e2258 = global_2.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2265 = ((_e2247 >> bitcast<u32>((_e2238 & 31u))) | ((_e2258 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2238) & 31u))));
let _e2268 = local_2.member_1[1u];
let _e2274 = f32(bitcast<i32>(((_e2265 >> bitcast<u32>((_e2268 & 31u))) & 255u)));
let _e2277 = local_2.member_1[2u];
let _e2284 = local_3[0u];
let _e2287 = (_e2274 + ((f32(bitcast<i32>(((_e2265 >> bitcast<u32>((_e2277 & 31u))) & 255u))) - _e2274) * _e2284));
let _e2289 = local_2.member[0u];
let _e2290 = ((_e2216 + _e2215) + _e2289);
let _e2292 = (_e2290 >> bitcast<u32>(2i));
let _e2295 = bitcast<u32>(((_e2290 & 3i) * 8i));
let _e2297 = select(_e2240, _e2292, (_e2292 < _e2240));
let _e2302 = global_2.member[bitcast<u32>(select(0i, _e2297, (_e2297 > 0i)))];
let _e2306 = (_e2292 + 1i);
let _e2308 = select(_e2240, _e2306, (_e2306 < _e2240));
let _e2313 = global_2.member[bitcast<u32>(select(0i, _e2308, (_e2308 > 0i)))];
let _e2320 = ((_e2302 >> bitcast<u32>((_e2295 & 31u))) | ((_e2313 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2295) & 31u))));
let _e2321 = local_2.member_1[1u];
let _e2327 = f32(bitcast<i32>(((_e2320 >> bitcast<u32>((_e2321 & 31u))) & 255u)));
let _e2328 = local_2.member_1[2u];
let _e2335 = local_3[0u];
let _e2340 = local_3[1u];
let _e2343 = (_e2287 + (((_e2327 + ((f32(bitcast<i32>(((_e2320 >> bitcast<u32>((_e2328 & 31u))) & 255u))) - _e2327) * _e2335)) - _e2287) * _e2340));
let _e2345 = local_2.member[0u];
let _e2346 = ((_e2217 + _e2214) + _e2345);
let _e2348 = (_e2346 >> bitcast<u32>(2i));
let _e2351 = bitcast<u32>(((_e2346 & 3i) * 8i));
let _e2353 = select(_e2240, _e2348, (_e2348 < _e2240));
let _e2358 = global_2.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2362 = (_e2348 + 1i);
let _e2364 = select(_e2240, _e2362, (_e2362 < _e2240));
let _e2369 = global_2.member[bitcast<u32>(select(0i, _e2364, (_e2364 > 0i)))];
let _e2376 = ((_e2358 >> bitcast<u32>((_e2351 & 31u))) | ((_e2369 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2351) & 31u))));
let _e2377 = local_2.member_1[1u];
let _e2383 = f32(bitcast<i32>(((_e2376 >> bitcast<u32>((_e2377 & 31u))) & 255u)));
let _e2384 = local_2.member_1[2u];
let _e2391 = local_3[0u];
let _e2394 = (_e2383 + ((f32(bitcast<i32>(((_e2376 >> bitcast<u32>((_e2384 & 31u))) & 255u))) - _e2383) * _e2391));
let _e2396 = local_2.member[0u];
let _e2397 = ((_e2217 + _e2215) + _e2396);
let _e2399 = (_e2397 >> bitcast<u32>(2i));
let _e2402 = bitcast<u32>(((_e2397 & 3i) * 8i));
let _e2404 = select(_e2240, _e2399, (_e2399 < _e2240));
let _e2409 = global_2.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2413 = (_e2399 + 1i);
let _e2415 = select(_e2240, _e2413, (_e2413 < _e2240));
let _e2420 = global_2.member[bitcast<u32>(select(0i, _e2415, (_e2415 > 0i)))];
let _e2427 = ((_e2409 >> bitcast<u32>((_e2402 & 31u))) | ((_e2420 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2402) & 31u))));
let _e2428 = local_2.member_1[1u];
let _e2434 = f32(bitcast<i32>(((_e2427 >> bitcast<u32>((_e2428 & 31u))) & 255u)));
let _e2435 = local_2.member_1[2u];
let _e2442 = local_3[0u];
let _e2446 = local_3[1u];
let _e2451 = local_3[2u];
let _e2458 = global_1.member.member_6.member_5;
let _e2463 = global_1.member.member_6.member_6;
let _e2464 = (((_e2343 + (((_e2394 + (((_e2434 + ((f32(bitcast<i32>(((_e2427 >> bitcast<u32>((_e2435 & 31u))) & 255u))) - _e2434) * _e2442)) - _e2394) * _e2446)) - _e2343) * _e2451)) * _e2458) + _e2463);
let _e2466 = select(0f, _e2464, (_e2464 > 0f));
phi_4673_ = type_30(select(1f, _e2466, (_e2466 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2471 = phi_4673_;
let _e2473 = select(-0.5f, _e394, (_e394 > -0.5f));
let _e2475 = select(_e452, _e2473, (_e2473 < _e452));
let _e2477 = select(-0.5f, _e409, (_e409 > -0.5f));
let _e2479 = select(_e462, _e2477, (_e2477 < _e462));
let _e2481 = select(-0.5f, _e424, (_e424 > -0.5f));
let _e2483 = select(_e472, _e2481, (_e2481 < _e472));
let _e2485 = select(-1f, _e2475, (_e2475 > -1f));
let _e2487 = select(_e451, _e2485, (_e2485 < _e451));
let _e2494 = select(0i, select(select(i32(_e2487), i32(-2147483648), (_e2487 < -2147483600f)), 2147483647i, (_e2487 > 2147483500f)), (_e2487 == _e2487));
let _e2498 = (_e2494 - select(0i, 1i, (_e2487 < f32(_e2494))));
let _e2500 = select(-1f, _e2479, (_e2479 > -1f));
let _e2502 = select(_e461, _e2500, (_e2500 < _e461));
let _e2509 = select(0i, select(select(i32(_e2502), i32(-2147483648), (_e2502 < -2147483600f)), 2147483647i, (_e2502 > 2147483500f)), (_e2502 == _e2502));
let _e2513 = (_e2509 - select(0i, 1i, (_e2502 < f32(_e2509))));
let _e2515 = select(-1f, _e2483, (_e2483 > -1f));
let _e2517 = select(_e471, _e2515, (_e2515 < _e471));
let _e2524 = select(0i, select(select(i32(_e2517), i32(-2147483648), (_e2517 < -2147483600f)), 2147483647i, (_e2517 > 2147483500f)), (_e2517 == _e2517));
let _e2528 = (_e2524 - select(0i, 1i, (_e2517 < f32(_e2524))));
let _e2532 = global_1.member.member_6.member_7;
let _e2536 = global_1.member.member_6.member_8;
let _e2544 = (select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461)) - 1i);
let _e2547 = (_e2513 + 1i);
let _e2557 = (select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < -2147483600f)), 2147483647i, (_e471 > 2147483500f)), (_e471 == _e471)) - 1i);
let _e2560 = (_e2528 + 1i);
let _e2569 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < -2147483600f)), 2147483647i, (_e451 > 2147483500f)), (_e451 == _e451));
let _e2570 = (_e2569 - 1i);
let _e2571 = (_e2498 - 1i);
let _e2573 = select(0i, _e2571, (_e2571 > 0i));
let _e2576 = (_e2498 + 1i);
let _e2579 = (_e2498 + 2i);
let _e2582 = (_e2569 - 4i);
let _e2584 = select(0i, _e2582, (_e2582 > 0i));
let _e2586 = select(_e2584, _e2573, (_e2573 < _e2584));
let _e2599 = (select(0i, _e2513, (_e2513 > 0i)) * _e2532);
let _e2600 = (select(_e2544, _e2547, (_e2547 < _e2544)) * _e2532);
let _e2601 = (select(0i, _e2528, (_e2528 > 0i)) * _e2536);
let _e2602 = (select(_e2557, _e2560, (_e2560 < _e2557)) * _e2536);
local = type_28(array<i32, 4>(_e2586, _e2586, _e2586, _e2586), array<u32, 6>(bitcast<u32>(((_e2573 - _e2586) * 8i)), bitcast<u32>(((select(0i, _e2498, (_e2498 > 0i)) - _e2586) * 8i)), bitcast<u32>(((select(_e2570, _e2576, (_e2576 < _e2570)) - _e2586) * 8i)), bitcast<u32>(((select(_e2570, _e2579, (_e2579 < _e2570)) - _e2586) * 8i)), 0u, 0u));
local_1 = vec3<f32>((_e2475 - f32(_e2498)), (_e2479 - f32(_e2513)), (_e2483 - f32(_e2528)));
let _e2617 = local.member[0u];
let _e2618 = ((_e2601 + _e2599) + _e2617);
let _e2620 = (_e2618 >> bitcast<u32>(2i));
let _e2623 = bitcast<u32>(((_e2618 & 3i) * 8i));
let _e2625 = (bitcast<i32>(_e91) - 1i);
let _e2627 = select(_e2625, _e2620, (_e2620 < _e2625));
let _e2632 = global_2.member[bitcast<u32>(select(0i, _e2627, (_e2627 > 0i)))];
let _e2636 = (_e2620 + 1i);
let _e2638 = select(_e2625, _e2636, (_e2636 < _e2625));
let _e2643 = global_2.member[bitcast<u32>(select(0i, _e2638, (_e2638 > 0i)))];
let _e2650 = ((_e2632 >> bitcast<u32>((_e2623 & 31u))) | ((_e2643 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2623) & 31u))));
let _e2653 = local.member_1[1u];
let _e2659 = f32(bitcast<i32>(((_e2650 >> bitcast<u32>((_e2653 & 31u))) & 255u)));
let _e2662 = local.member_1[2u];
let _e2669 = local_1[0u];
let _e2672 = (_e2659 + ((f32(bitcast<i32>(((_e2650 >> bitcast<u32>((_e2662 & 31u))) & 255u))) - _e2659) * _e2669));
let _e2674 = local.member[0u];
let _e2675 = ((_e2601 + _e2600) + _e2674);
let _e2677 = (_e2675 >> bitcast<u32>(2i));
let _e2680 = bitcast<u32>(((_e2675 & 3i) * 8i));
let _e2682 = select(_e2625, _e2677, (_e2677 < _e2625));
let _e2687 = global_2.member[bitcast<u32>(select(0i, _e2682, (_e2682 > 0i)))];
let _e2691 = (_e2677 + 1i);
let _e2693 = select(_e2625, _e2691, (_e2691 < _e2625));
let _e2698 = global_2.member[bitcast<u32>(select(0i, _e2693, (_e2693 > 0i)))];
let _e2705 = ((_e2687 >> bitcast<u32>((_e2680 & 31u))) | ((_e2698 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2680) & 31u))));
let _e2706 = local.member_1[1u];
let _e2712 = f32(bitcast<i32>(((_e2705 >> bitcast<u32>((_e2706 & 31u))) & 255u)));
let _e2713 = local.member_1[2u];
let _e2720 = local_1[0u];
let _e2725 = local_1[1u];
let _e2728 = (_e2672 + (((_e2712 + ((f32(bitcast<i32>(((_e2705 >> bitcast<u32>((_e2713 & 31u))) & 255u))) - _e2712) * _e2720)) - _e2672) * _e2725));
let _e2730 = local.member[0u];
let _e2731 = ((_e2602 + _e2599) + _e2730);
let _e2733 = (_e2731 >> bitcast<u32>(2i));
let _e2736 = bitcast<u32>(((_e2731 & 3i) * 8i));
let _e2738 = select(_e2625, _e2733, (_e2733 < _e2625));
let _e2743 = global_2.member[bitcast<u32>(select(0i, _e2738, (_e2738 > 0i)))];
let _e2747 = (_e2733 + 1i);
let _e2749 = select(_e2625, _e2747, (_e2747 < _e2625));
let _e2754 = global_2.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2761 = ((_e2743 >> bitcast<u32>((_e2736 & 31u))) | ((_e2754 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2736) & 31u))));
let _e2762 = local.member_1[1u];
let _e2768 = f32(bitcast<i32>(((_e2761 >> bitcast<u32>((_e2762 & 31u))) & 255u)));
let _e2769 = local.member_1[2u];
let _e2776 = local_1[0u];
let _e2779 = (_e2768 + ((f32(bitcast<i32>(((_e2761 >> bitcast<u32>((_e2769 & 31u))) & 255u))) - _e2768) * _e2776));
let _e2781 = local.member[0u];
let _e2782 = ((_e2602 + _e2600) + _e2781);
let _e2784 = (_e2782 >> bitcast<u32>(2i));
let _e2787 = bitcast<u32>(((_e2782 & 3i) * 8i));
let _e2789 = select(_e2625, _e2784, (_e2784 < _e2625));
let _e2794 = global_2.member[bitcast<u32>(select(0i, _e2789, (_e2789 > 0i)))];
let _e2798 = (_e2784 + 1i);
let _e2800 = select(_e2625, _e2798, (_e2798 < _e2625));
let _e2805 = global_2.member[bitcast<u32>(select(0i, _e2800, (_e2800 > 0i)))];
let _e2812 = ((_e2794 >> bitcast<u32>((_e2787 & 31u))) | ((_e2805 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2787) & 31u))));
let _e2813 = local.member_1[1u];
let _e2819 = f32(bitcast<i32>(((_e2812 >> bitcast<u32>((_e2813 & 31u))) & 255u)));
let _e2820 = local.member_1[2u];
let _e2827 = local_1[0u];
let _e2831 = local_1[1u];
let _e2836 = local_1[2u];
let _e2843 = global_1.member.member_6.member_5;
let _e2848 = global_1.member.member_6.member_6;
let _e2849 = (((_e2728 + (((_e2779 + (((_e2819 + ((f32(bitcast<i32>(((_e2812 >> bitcast<u32>((_e2820 & 31u))) & 255u))) - _e2819) * _e2827)) - _e2779) * _e2831)) - _e2728) * _e2836)) * _e2843) + _e2848);
let _e2851 = select(0f, _e2849, (_e2849 > 0f));
if ((_e610 & 16u) == 0u) {
phi_5658_ = type_5(1f, 1f, 1f);
} else {
let _e2859 = global_1.member.member_14.member;
let _e2870 = ((((_e2859.member.member * _e305) + (_e2859.member.member_1 * _e314)) + (_e2859.member.member_2 * _e287)) + _e2859.member_1);
let _e2876 = ((((_e2859.member.member * _e326) + (_e2859.member.member_1 * _e331)) + (_e2859.member.member_2 * _e320)) + _e2859.member_1);
let _e2878 = select(_e2876, _e2870, (_e2870 < _e2876));
let _e2880 = select(_e2876, _e2870, (_e2870 > _e2876));
let _e2882 = (_e2880 - _e2878);
let _e2885 = (-(_e2878) / select(1e-30f, _e2882, (_e2882 > 1e-30f)));
let _e2887 = select(0f, _e2885, (_e2885 > 0f));
let _e2893 = select(select(select(1f, _e2887, (_e2887 < 1f)), 1f, (_e2880 <= 0f)), 0f, (_e2878 > 0f));
let _e2898 = global_1.member.member_14.member_1;
let _e2899 = (_e2898 != 0u);
let _e2909 = global_1.member.member_15.member;
let _e2920 = ((((_e2909.member.member * _e305) + (_e2909.member.member_1 * _e314)) + (_e2909.member.member_2 * _e287)) + _e2909.member_1);
let _e2926 = ((((_e2909.member.member * _e326) + (_e2909.member.member_1 * _e331)) + (_e2909.member.member_2 * _e320)) + _e2909.member_1);
let _e2928 = select(_e2926, _e2920, (_e2920 < _e2926));
let _e2930 = select(_e2926, _e2920, (_e2920 > _e2926));
let _e2932 = (_e2930 - _e2928);
let _e2935 = (-(_e2928) / select(1e-30f, _e2932, (_e2932 > 1e-30f)));
let _e2937 = select(0f, _e2935, (_e2935 > 0f));
let _e2943 = select(select(select(1f, _e2937, (_e2937 < 1f)), 1f, (_e2930 <= 0f)), 0f, (_e2928 > 0f));
let _e2948 = global_1.member.member_15.member_1;
let _e2949 = (_e2948 != 0u);
let _e2959 = global_1.member.member_16.member;
let _e2970 = ((((_e2959.member.member * _e305) + (_e2959.member.member_1 * _e314)) + (_e2959.member.member_2 * _e287)) + _e2959.member_1);
let _e2976 = ((((_e2959.member.member * _e326) + (_e2959.member.member_1 * _e331)) + (_e2959.member.member_2 * _e320)) + _e2959.member_1);
let _e2978 = select(_e2976, _e2970, (_e2970 < _e2976));
let _e2980 = select(_e2976, _e2970, (_e2970 > _e2976));
let _e2982 = (_e2980 - _e2978);
let _e2985 = (-(_e2978) / select(1e-30f, _e2982, (_e2982 > 1e-30f)));
let _e2987 = select(0f, _e2985, (_e2985 > 0f));
let _e2993 = select(select(select(1f, _e2987, (_e2987 < 1f)), 1f, (_e2980 <= 0f)), 0f, (_e2978 > 0f));
let _e2998 = global_1.member.member_16.member_1;
let _e2999 = (_e2998 != 0u);
let _e3009 = global_1.member.member_17.member;
let _e3020 = ((((_e3009.member.member * _e305) + (_e3009.member.member_1 * _e314)) + (_e3009.member.member_2 * _e287)) + _e3009.member_1);
let _e3026 = ((((_e3009.member.member * _e326) + (_e3009.member.member_1 * _e331)) + (_e3009.member.member_2 * _e320)) + _e3009.member_1);
let _e3028 = select(_e3026, _e3020, (_e3020 < _e3026));
let _e3030 = select(_e3026, _e3020, (_e3020 > _e3026));
let _e3032 = (_e3030 - _e3028);
let _e3035 = (-(_e3028) / select(1e-30f, _e3032, (_e3032 > 1e-30f)));
let _e3037 = select(0f, _e3035, (_e3035 > 0f));
let _e3043 = select(select(select(1f, _e3037, (_e3037 < 1f)), 1f, (_e3030 <= 0f)), 0f, (_e3028 > 0f));
let _e3048 = global_1.member.member_17.member_1;
let _e3049 = (_e3048 != 0u);
phi_5658_ = type_5(((((1f * _e2893) * _e2943) * _e2993) * _e3043), ((((1f * select(1f, _e2893, _e2899)) * select(1f, _e2943, _e2949)) * select(1f, _e2993, _e2999)) * select(1f, _e3043, _e3049)), ((((1f * select(1f, 0f, (_e2899 && (_e2876 > 0f)))) * select(1f, 0f, (_e2949 && (_e2926 > 0f)))) * select(1f, 0f, (_e2999 && (_e2976 > 0f)))) * select(1f, 0f, (_e3049 && (_e3026 > 0f)))));
}
let _e3058 = phi_5658_;
let _e3059 = (_e326 - _e305);
let _e3060 = (_e331 - _e314);
let _e3061 = (_e320 - _e287);
let _e3066 = (((_e3059 * _e3059) + (_e3060 * _e3060)) + (_e3061 * _e3061));
let _e3070 = (_e482 < 1e-12f);
let _e3072 = (1f / select(_e477, 1f, _e3070));
let _e3074 = ((-0.5f - _e394) * _e3072);
let _e3076 = ((_e452 - _e394) * _e3072);
let _e3082 = select(_e3076, _e3074, (_e3074 < _e3076));
let _e3084 = select(0f, _e3082, (_e3082 > 0f));
let _e3087 = select(select(1f, _e3084, (_e3084 < 1f)), select(2f, 0f, ((_e394 >= -0.5f) && (_e394 <= _e452))), _e3070);
let _e3089 = select(_e3076, _e3074, (_e3074 > _e3076));
let _e3091 = select(0f, _e3089, (_e3089 > 0f));
let _e3094 = select(select(1f, _e3091, (_e3091 < 1f)), 1f, _e3070);
let _e3095 = (_e485 < 1e-12f);
let _e3097 = (1f / select(_e478, 1f, _e3095));
let _e3099 = ((-0.5f - _e409) * _e3097);
let _e3101 = ((_e462 - _e409) * _e3097);
let _e3107 = select(_e3101, _e3099, (_e3099 < _e3101));
let _e3109 = select(0f, _e3107, (_e3107 > 0f));
let _e3112 = select(select(1f, _e3109, (_e3109 < 1f)), select(2f, 0f, ((_e409 >= -0.5f) && (_e409 <= _e462))), _e3095);
let _e3114 = select(_e3101, _e3099, (_e3099 > _e3101));
let _e3116 = select(0f, _e3114, (_e3114 > 0f));
let _e3119 = select(select(1f, _e3116, (_e3116 < 1f)), 1f, _e3095);
let _e3120 = (_e490 < 1e-12f);
let _e3122 = (1f / select(_e479, 1f, _e3120));
let _e3124 = ((-0.5f - _e424) * _e3122);
let _e3126 = ((_e472 - _e424) * _e3122);
let _e3132 = select(_e3126, _e3124, (_e3124 < _e3126));
let _e3134 = select(0f, _e3132, (_e3132 > 0f));
let _e3137 = select(select(1f, _e3134, (_e3134 < 1f)), select(2f, 0f, ((_e424 >= -0.5f) && (_e424 <= _e472))), _e3120);
let _e3139 = select(_e3126, _e3124, (_e3124 > _e3126));
let _e3141 = select(0f, _e3139, (_e3139 > 0f));
let _e3144 = select(select(1f, _e3141, (_e3141 < 1f)), 1f, _e3120);
let _e3146 = select(_e3119, _e3094, (_e3094 < _e3119));
let _e3150 = select(_e3112, _e3087, (_e3087 > _e3112));
let _e3153 = (select(_e3144, _e3146, (_e3146 < _e3144)) - select(_e3137, _e3150, (_e3150 > _e3137)));
let _e3160 = global_1.member.member_5.member_3;
let _e3161 = ((sqrt(select(0f, _e3066, (_e3066 > 0f))) * select(0f, _e3153, (_e3153 > 0f))) * _e3160);
let _e3163 = (select(1f, _e2851, (_e2851 < 1f)) * 255f);
let _e3164 = (_e2471.member * 255f);
let _e3165 = (255f - 1f);
let _e3167 = select(0f, _e3163, (_e3163 > 0f));
let _e3169 = select(_e3165, _e3167, (_e3167 < _e3165));
let _e3176 = select(0i, select(select(i32(_e3169), i32(-2147483648), (_e3169 < -2147483600f)), 2147483647i, (_e3169 > 2147483500f)), (_e3169 == _e3169));
let _e3180 = (_e3176 - select(0i, 1i, (_e3169 < f32(_e3176))));
let _e3182 = select(0f, _e3164, (_e3164 > 0f));
let _e3184 = select(_e3165, _e3182, (_e3182 < _e3165));
let _e3191 = select(0i, select(select(i32(_e3184), i32(-2147483648), (_e3184 < -2147483600f)), 2147483647i, (_e3184 > 2147483500f)), (_e3184 == _e3184));
let _e3195 = (_e3191 - select(0i, 1i, (_e3184 < f32(_e3191))));
let _e3198 = (((_e3180 * 256i) + _e3195) * 4i);
let _e3200 = (_e3163 - f32(_e3180));
let _e3202 = (_e3164 - f32(_e3195));
let _e3204 = (bitcast<i32>(_e95) - 1i);
let _e3206 = select(_e3204, _e3198, (_e3198 < _e3204));
let _e3212 = global_4.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3213 = (_e3198 + 4i);
let _e3215 = select(_e3204, _e3213, (_e3213 < _e3204));
let _e3221 = global_4.member[bitcast<u32>(select(0i, _e3215, (_e3215 > 0i)))];
let _e3222 = (_e3198 + 1024i);
let _e3224 = select(_e3204, _e3222, (_e3222 < _e3204));
let _e3230 = global_4.member[bitcast<u32>(select(0i, _e3224, (_e3224 > 0i)))];
let _e3231 = (_e3198 + 1028i);
let _e3233 = select(_e3204, _e3231, (_e3231 < _e3204));
let _e3239 = global_4.member[bitcast<u32>(select(0i, _e3233, (_e3233 > 0i)))];
let _e3244 = (bitcast<f32>(((_e3212 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3252 = (_e3244 + (((bitcast<f32>(((_e3221 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3244) * _e3202));
let _e3257 = (bitcast<f32>(((_e3230 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3281 = (bitcast<f32>((((_e3212 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3289 = (_e3281 + (((bitcast<f32>((((_e3221 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3281) * _e3202));
let _e3294 = (bitcast<f32>((((_e3230 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3306 = (_e3198 + 1i);
let _e3308 = select(_e3204, _e3306, (_e3306 < _e3204));
let _e3314 = global_4.member[bitcast<u32>(select(0i, _e3308, (_e3308 > 0i)))];
let _e3315 = (_e3198 + 5i);
let _e3317 = select(_e3204, _e3315, (_e3315 < _e3204));
let _e3323 = global_4.member[bitcast<u32>(select(0i, _e3317, (_e3317 > 0i)))];
let _e3324 = (_e3198 + 1025i);
let _e3326 = select(_e3204, _e3324, (_e3324 < _e3204));
let _e3332 = global_4.member[bitcast<u32>(select(0i, _e3326, (_e3326 > 0i)))];
let _e3333 = (_e3198 + 1029i);
let _e3335 = select(_e3204, _e3333, (_e3333 < _e3204));
let _e3341 = global_4.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3346 = (bitcast<f32>(((_e3314 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3354 = (_e3346 + (((bitcast<f32>(((_e3323 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3346) * _e3202));
let _e3359 = (bitcast<f32>(((_e3332 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3383 = (bitcast<f32>((((_e3314 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3391 = (_e3383 + (((bitcast<f32>((((_e3323 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3383) * _e3202));
let _e3396 = (bitcast<f32>((((_e3332 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3411 = (_e3161 * _e3058.member_1);
let _e3413 = -(((_e3289 + (((_e3294 + (((bitcast<f32>((((_e3239 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3294) * _e3202)) - _e3289) * _e3200)) * _e3411));
let _e3415 = select(-87f, _e3413, (_e3413 > -87f));
let _e3417 = select(88f, _e3415, (_e3415 < 88f));
let _e3419 = ((_e3417 * 1.442695f) + 0.5f);
let _e3421 = select(-127f, _e3419, (_e3419 > -127f));
let _e3423 = select(128f, _e3421, (_e3421 < 128f));
let _e3430 = select(0i, select(select(i32(_e3423), i32(-2147483648), (_e3423 < -2147483600f)), 2147483647i, (_e3423 > 2147483500f)), (_e3423 == _e3423));
let _e3434 = (_e3430 - select(0i, 1i, (_e3423 < f32(_e3430))));
let _e3435 = f32(_e3434);
let _e3439 = ((_e3417 - (_e3435 * 0.6933594f)) - (_e3435 * -2.1219444e-4f));
let _e3461 = -(((_e3354 + (((_e3359 + (((bitcast<f32>(((_e3341 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3359) * _e3202)) - _e3354) * _e3200)) * _e3411));
let _e3463 = select(-87f, _e3461, (_e3461 > -87f));
let _e3465 = select(88f, _e3463, (_e3463 < 88f));
let _e3467 = ((_e3465 * 1.442695f) + 0.5f);
let _e3469 = select(-127f, _e3467, (_e3467 > -127f));
let _e3471 = select(128f, _e3469, (_e3469 < 128f));
let _e3478 = select(0i, select(select(i32(_e3471), i32(-2147483648), (_e3471 < -2147483600f)), 2147483647i, (_e3471 > 2147483500f)), (_e3471 == _e3471));
let _e3482 = (_e3478 - select(0i, 1i, (_e3471 < f32(_e3478))));
let _e3483 = f32(_e3482);
let _e3487 = ((_e3465 - (_e3483 * 0.6933594f)) - (_e3483 * -2.1219444e-4f));
let _e3509 = -(((_e3391 + (((_e3396 + (((bitcast<f32>((((_e3341 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3396) * _e3202)) - _e3391) * _e3200)) * _e3411));
let _e3511 = select(-87f, _e3509, (_e3509 > -87f));
let _e3513 = select(88f, _e3511, (_e3511 < 88f));
let _e3515 = ((_e3513 * 1.442695f) + 0.5f);
let _e3517 = select(-127f, _e3515, (_e3515 > -127f));
let _e3519 = select(128f, _e3517, (_e3517 < 128f));
let _e3526 = select(0i, select(select(i32(_e3519), i32(-2147483648), (_e3519 < -2147483600f)), 2147483647i, (_e3519 > 2147483500f)), (_e3519 == _e3519));
let _e3530 = (_e3526 - select(0i, 1i, (_e3519 < f32(_e3526))));
let _e3531 = f32(_e3530);
let _e3535 = ((_e3513 - (_e3531 * 0.6933594f)) - (_e3531 * -2.1219444e-4f));
let _e3557 = -(((_e3252 + (((_e3257 + (((bitcast<f32>(((_e3239 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3257) * _e3202)) - _e3252) * _e3200)) * (_e3161 * _e3058.member)));
let _e3559 = select(-87f, _e3557, (_e3557 > -87f));
let _e3561 = select(88f, _e3559, (_e3559 < 88f));
let _e3563 = ((_e3561 * 1.442695f) + 0.5f);
let _e3565 = select(-127f, _e3563, (_e3563 > -127f));
let _e3567 = select(128f, _e3565, (_e3565 < 128f));
let _e3574 = select(0i, select(select(i32(_e3567), i32(-2147483648), (_e3567 < -2147483600f)), 2147483647i, (_e3567 > 2147483500f)), (_e3567 == _e3567));
let _e3578 = (_e3574 - select(0i, 1i, (_e3567 < f32(_e3574))));
let _e3579 = f32(_e3578);
let _e3583 = ((_e3561 - (_e3579 * 0.6933594f)) - (_e3579 * -2.1219444e-4f));
let _e3603 = ((1f + (_e3583 * (1f + (_e3583 * (0.5f + (_e3583 * (0.16666667f + (_e3583 * (0.041666668f + (_e3583 * (0.008333334f + (_e3583 * (0.001388889f + (_e3583 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3578 + 127i)) << bitcast<u32>(23i))));
if _e627 {
let _e3618 = global_1.member.member_5.member_4;
let _e3621 = (_e2471.member_3.x * _e3058.member_2);
let _e3623 = (_e2471.member_3.y * _e3058.member_2);
let _e3625 = (_e2471.member_3.z * _e3058.member_2);
let _e3626 = (0.5f * (_e244 / _e196));
let _e3630 = (_e174 + (_e3621 * _e3626));
let _e3631 = (_e185 + (_e3623 * _e3626));
let _e3632 = (_e196 + (_e3625 * _e3626));
let _e3634 = (2f * _e244);
let _e3636 = ((_e3632 * _e3632) + (_e3634 * _e3625));
let _e3640 = (_e3632 + sqrt(select(0f, _e3636, (_e3636 > 0f))));
let _e3644 = (0.5f * (_e3634 / select(1e-6f, _e3640, (_e3640 > 1e-6f))));
let _e3648 = (_e3630 + (_e3621 * _e3644));
let _e3649 = (_e3631 + (_e3623 * _e3644));
let _e3650 = (_e3632 + (_e3625 * _e3644));
let _e3654 = (_e3618 * _e3618);
let _e3656 = (_e3650 * _e3650);
let _e3664 = (((_e3632 <= 0f) || (_e3636 <= 0f)) || ((_e3650 <= 0f) || (_e3656 <= (_e3654 * (((_e3648 * _e3648) + (_e3649 * _e3649)) + _e3656)))));
let _e3678 = (_e174 + ((_e2471.member_4.x * _e3058.member_2) * _e244));
let _e3679 = (_e185 + ((_e2471.member_4.y * _e3058.member_2) * _e244));
let _e3680 = (_e196 + ((_e2471.member_4.z * _e3058.member_2) * _e244));
let _e3682 = (_e3680 * _e3680);
let _e3691 = ((_e610 & 1u) != 0u);
phi_6682_ = select(select(select(_e3650, _e3632, _e3664), _e3680, _e3691), _e196, _e617);
phi_6683_ = select(select(select(_e3649, _e3631, _e3664), _e3679, _e3691), _e185, _e617);
phi_6684_ = select(select(select(_e3648, _e3630, _e3664), _e3678, _e3691), _e174, _e617);
phi_6685_ = (select(_e3664, ((_e3680 <= 0f) || (_e3682 <= (_e3654 * (((_e3678 * _e3678) + (_e3679 * _e3679)) + _e3682)))), _e3691) && !(_e617));
} else {
phi_6682_ = _e196;
phi_6683_ = _e185;
phi_6684_ = _e174;
phi_6685_ = false;
}
let _e3702 = phi_6682_;
let _e3704 = phi_6683_;
let _e3706 = phi_6684_;
let _e3708 = phi_6685_;
global_6.member[_e120] = (_e131 + _e259);
global_6.member[_e132] = (_e141 + _e266);
global_6.member[_e143] = (_e152 + _e368);
global_6.member[_e154] = (_e163 + _e371);
global_6.member[_e165] = _e3706;
global_6.member[_e176] = _e3704;
global_6.member[_e187] = _e3702;
global_6.member[_e198] = select((_e207 * (((1f + (_e3439 * (1f + (_e3439 * (0.5f + (_e3439 * (0.16666667f + (_e3439 * (0.041666668f + (_e3439 * (0.008333334f + (_e3439 * (0.001388889f + (_e3439 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3434 + 127i)) << bitcast<u32>(23i)))) * _e3603)), _e207, _e617);
global_6.member[_e209] = select((_e218 * (((1f + (_e3487 * (1f + (_e3487 * (0.5f + (_e3487 * (0.16666667f + (_e3487 * (0.041666668f + (_e3487 * (0.008333334f + (_e3487 * (0.001388889f + (_e3487 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3482 + 127i)) << bitcast<u32>(23i)))) * _e3603)), _e218, _e617);
global_6.member[_e220] = select((_e229 * (((1f + (_e3535 * (1f + (_e3535 * (0.5f + (_e3535 * (0.16666667f + (_e3535 * (0.041666668f + (_e3535 * (0.008333334f + (_e3535 * (0.001388889f + (_e3535 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3530 + 127i)) << bitcast<u32>(23i)))) * _e3603)), _e229, _e617);
global_6.member[_e231] = select(_e240, 1f, _e3708);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
