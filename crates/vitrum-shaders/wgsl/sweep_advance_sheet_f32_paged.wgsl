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
var phi_3637_: type_29;
var phi_4246_: type_30;
var phi_5078_: type_5;
var phi_6102_: f32;
var phi_6103_: f32;
var phi_6104_: f32;
var phi_6105_: bool;
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
let _e681 = (_e642 + 1i);
let _e682 = (_e657 + 1i);
let _e683 = (_e672 + 1i);
let _e688 = global_1.member.member_6.member_11.member;
let _e694 = global_1.member.member_6.member_11.member_1;
let _e705 = ((_e681 >> bitcast<u32>(4i)) + (bitcast<i32>(_e688) * ((_e682 >> bitcast<u32>(4i)) + (bitcast<i32>(_e694) * (_e683 >> bitcast<u32>(4i))))));
let _e707 = (bitcast<i32>(_e91) - 1i);
let _e709 = select(_e707, _e705, (_e705 < _e707));
let _e715 = global_2.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e717 = (_e681 & 15i);
let _e720 = ((_e682 & 15i) * _e676);
let _e722 = (bitcast<i32>(_e715) + ((_e683 & 15i) * _e680));
let _e726 = (_e720 + _e676);
let _e728 = (_e720 + (2i * _e676));
let _e730 = (_e720 + (3i * _e676));
let _e731 = (_e722 + _e680);
let _e733 = (_e722 + (2i * _e680));
let _e735 = (_e722 + (3i * _e680));
local_4 = type_28(array<i32, 4>(_e717, (_e717 + 1i), (_e717 + 2i), (_e717 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e456 - f32(_e642)), (_e466 - f32(_e657)), (_e476 - f32(_e672)));
let _e746 = (_e731 + _e726);
let _e749 = local_4.member[0u];
let _e750 = (_e746 + _e749);
let _e752 = select(_e707, _e750, (_e750 < _e707));
let _e757 = global_2.member[bitcast<u32>(select(0i, _e752, (_e752 > 0i)))];
let _e758 = bitcast<f32>(_e757);
let _e761 = local_4.member[1u];
let _e762 = (_e746 + _e761);
let _e764 = select(_e707, _e762, (_e762 < _e707));
let _e769 = global_2.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e770 = bitcast<f32>(_e769);
let _e773 = local_4.member[2u];
let _e774 = (_e746 + _e773);
let _e776 = select(_e707, _e774, (_e774 < _e707));
let _e781 = global_2.member[bitcast<u32>(select(0i, _e776, (_e776 > 0i)))];
let _e782 = bitcast<f32>(_e781);
let _e785 = local_4.member[3u];
let _e786 = (_e746 + _e785);
let _e788 = select(_e707, _e786, (_e786 < _e707));
let _e793 = global_2.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e795 = local_5[0u];
let _e798 = (_e758 + ((_e770 - _e758) * _e795));
let _e799 = local_5[0u];
let _e802 = (_e770 + ((_e782 - _e770) * _e799));
let _e803 = local_5[0u];
let _e806 = (_e782 + ((bitcast<f32>(_e793) - _e782) * _e803));
let _e807 = (_e731 + _e728);
let _e808 = local_4.member[0u];
let _e809 = (_e807 + _e808);
let _e811 = select(_e707, _e809, (_e809 < _e707));
let _e816 = global_2.member[bitcast<u32>(select(0i, _e811, (_e811 > 0i)))];
let _e817 = bitcast<f32>(_e816);
let _e818 = local_4.member[1u];
let _e819 = (_e807 + _e818);
let _e821 = select(_e707, _e819, (_e819 < _e707));
let _e826 = global_2.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e827 = bitcast<f32>(_e826);
let _e828 = local_4.member[2u];
let _e829 = (_e807 + _e828);
let _e831 = select(_e707, _e829, (_e829 < _e707));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e837 = bitcast<f32>(_e836);
let _e838 = local_4.member[3u];
let _e839 = (_e807 + _e838);
let _e841 = select(_e707, _e839, (_e839 < _e707));
let _e846 = global_2.member[bitcast<u32>(select(0i, _e841, (_e841 > 0i)))];
let _e848 = local_5[0u];
let _e852 = local_5[0u];
let _e855 = (_e827 + ((_e837 - _e827) * _e852));
let _e856 = local_5[0u];
let _e860 = (_e733 + _e726);
let _e861 = local_4.member[0u];
let _e862 = (_e860 + _e861);
let _e864 = select(_e707, _e862, (_e862 < _e707));
let _e869 = global_2.member[bitcast<u32>(select(0i, _e864, (_e864 > 0i)))];
let _e870 = bitcast<f32>(_e869);
let _e871 = local_4.member[1u];
let _e872 = (_e860 + _e871);
let _e874 = select(_e707, _e872, (_e872 < _e707));
let _e879 = global_2.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e880 = bitcast<f32>(_e879);
let _e881 = local_4.member[2u];
let _e882 = (_e860 + _e881);
let _e884 = select(_e707, _e882, (_e882 < _e707));
let _e889 = global_2.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e890 = bitcast<f32>(_e889);
let _e891 = local_4.member[3u];
let _e892 = (_e860 + _e891);
let _e894 = select(_e707, _e892, (_e892 < _e707));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e901 = local_5[0u];
let _e904 = (_e870 + ((_e880 - _e870) * _e901));
let _e905 = local_5[0u];
let _e908 = (_e880 + ((_e890 - _e880) * _e905));
let _e909 = local_5[0u];
let _e912 = (_e890 + ((bitcast<f32>(_e899) - _e890) * _e909));
let _e913 = (_e733 + _e728);
let _e914 = local_4.member[0u];
let _e915 = (_e913 + _e914);
let _e917 = select(_e707, _e915, (_e915 < _e707));
let _e922 = global_2.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e923 = bitcast<f32>(_e922);
let _e924 = local_4.member[1u];
let _e925 = (_e913 + _e924);
let _e927 = select(_e707, _e925, (_e925 < _e707));
let _e932 = global_2.member[bitcast<u32>(select(0i, _e927, (_e927 > 0i)))];
let _e933 = bitcast<f32>(_e932);
let _e934 = local_4.member[2u];
let _e935 = (_e913 + _e934);
let _e937 = select(_e707, _e935, (_e935 < _e707));
let _e942 = global_2.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e943 = bitcast<f32>(_e942);
let _e944 = local_4.member[3u];
let _e945 = (_e913 + _e944);
let _e947 = select(_e707, _e945, (_e945 < _e707));
let _e952 = global_2.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
let _e954 = local_5[0u];
let _e958 = local_5[0u];
let _e961 = (_e933 + ((_e943 - _e933) * _e958));
let _e962 = local_5[0u];
let _e966 = (_e731 + _e720);
let _e967 = local_4.member[1u];
let _e968 = (_e966 + _e967);
let _e970 = select(_e707, _e968, (_e968 < _e707));
let _e975 = global_2.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e976 = bitcast<f32>(_e975);
let _e977 = local_4.member[2u];
let _e978 = (_e966 + _e977);
let _e980 = select(_e707, _e978, (_e978 < _e707));
let _e985 = global_2.member[bitcast<u32>(select(0i, _e980, (_e980 > 0i)))];
let _e987 = local_5[0u];
let _e990 = (_e976 + ((bitcast<f32>(_e985) - _e976) * _e987));
let _e991 = (_e731 + _e730);
let _e992 = local_4.member[1u];
let _e993 = (_e991 + _e992);
let _e995 = select(_e707, _e993, (_e993 < _e707));
let _e1000 = global_2.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1001 = bitcast<f32>(_e1000);
let _e1002 = local_4.member[2u];
let _e1003 = (_e991 + _e1002);
let _e1005 = select(_e707, _e1003, (_e1003 < _e707));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1012 = local_5[0u];
let _e1016 = (_e733 + _e720);
let _e1017 = local_4.member[1u];
let _e1018 = (_e1016 + _e1017);
let _e1020 = select(_e707, _e1018, (_e1018 < _e707));
let _e1025 = global_2.member[bitcast<u32>(select(0i, _e1020, (_e1020 > 0i)))];
let _e1026 = bitcast<f32>(_e1025);
let _e1027 = local_4.member[2u];
let _e1028 = (_e1016 + _e1027);
let _e1030 = select(_e707, _e1028, (_e1028 < _e707));
let _e1035 = global_2.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1037 = local_5[0u];
let _e1040 = (_e1026 + ((bitcast<f32>(_e1035) - _e1026) * _e1037));
let _e1041 = (_e733 + _e730);
let _e1042 = local_4.member[1u];
let _e1043 = (_e1041 + _e1042);
let _e1045 = select(_e707, _e1043, (_e1043 < _e707));
let _e1050 = global_2.member[bitcast<u32>(select(0i, _e1045, (_e1045 > 0i)))];
let _e1051 = bitcast<f32>(_e1050);
let _e1052 = local_4.member[2u];
let _e1053 = (_e1041 + _e1052);
let _e1055 = select(_e707, _e1053, (_e1053 < _e707));
let _e1060 = global_2.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1062 = local_5[0u];
let _e1066 = (_e722 + _e726);
let _e1067 = local_4.member[1u];
let _e1068 = (_e1066 + _e1067);
let _e1070 = select(_e707, _e1068, (_e1068 < _e707));
let _e1075 = global_2.member[bitcast<u32>(select(0i, _e1070, (_e1070 > 0i)))];
let _e1076 = bitcast<f32>(_e1075);
let _e1077 = local_4.member[2u];
let _e1078 = (_e1066 + _e1077);
let _e1080 = select(_e707, _e1078, (_e1078 < _e707));
let _e1085 = global_2.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1087 = local_5[0u];
let _e1090 = (_e1076 + ((bitcast<f32>(_e1085) - _e1076) * _e1087));
let _e1091 = (_e735 + _e726);
let _e1092 = local_4.member[1u];
let _e1093 = (_e1091 + _e1092);
let _e1095 = select(_e707, _e1093, (_e1093 < _e707));
let _e1100 = global_2.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1101 = bitcast<f32>(_e1100);
let _e1102 = local_4.member[2u];
let _e1103 = (_e1091 + _e1102);
let _e1105 = select(_e707, _e1103, (_e1103 < _e707));
let _e1110 = global_2.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1112 = local_5[0u];
let _e1115 = (_e1101 + ((bitcast<f32>(_e1110) - _e1101) * _e1112));
let _e1116 = (_e722 + _e728);
let _e1117 = local_4.member[1u];
let _e1118 = (_e1116 + _e1117);
let _e1120 = select(_e707, _e1118, (_e1118 < _e707));
let _e1125 = global_2.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1126 = bitcast<f32>(_e1125);
let _e1127 = local_4.member[2u];
let _e1128 = (_e1116 + _e1127);
let _e1130 = select(_e707, _e1128, (_e1128 < _e707));
let _e1135 = global_2.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1137 = local_5[0u];
let _e1141 = (_e735 + _e728);
let _e1142 = local_4.member[1u];
let _e1143 = (_e1141 + _e1142);
let _e1145 = select(_e707, _e1143, (_e1143 < _e707));
let _e1150 = global_2.member[bitcast<u32>(select(0i, _e1145, (_e1145 > 0i)))];
let _e1151 = bitcast<f32>(_e1150);
let _e1152 = local_4.member[2u];
let _e1153 = (_e1141 + _e1152);
let _e1155 = select(_e707, _e1153, (_e1153 < _e707));
let _e1160 = global_2.member[bitcast<u32>(select(0i, _e1155, (_e1155 > 0i)))];
let _e1162 = local_5[0u];
let _e1167 = local_5[1u];
let _e1170 = (_e802 + ((_e855 - _e802) * _e1167));
let _e1171 = local_5[1u];
let _e1174 = (_e908 + ((_e961 - _e908) * _e1171));
let _e1175 = local_5[1u];
let _e1178 = (_e798 + (((_e817 + ((_e827 - _e817) * _e848)) - _e798) * _e1175));
let _e1179 = local_5[1u];
let _e1184 = local_5[2u];
let _e1188 = local_5[1u];
let _e1191 = (_e806 + (((_e837 + ((bitcast<f32>(_e846) - _e837) * _e856)) - _e806) * _e1188));
let _e1192 = local_5[1u];
let _e1196 = local_5[2u];
let _e1200 = local_5[1u];
let _e1203 = (_e990 + ((_e802 - _e990) * _e1200));
let _e1204 = local_5[1u];
let _e1208 = local_5[2u];
let _e1212 = local_5[1u];
let _e1215 = (_e855 + (((_e1001 + ((bitcast<f32>(_e1010) - _e1001) * _e1012)) - _e855) * _e1212));
let _e1216 = local_5[1u];
let _e1220 = local_5[2u];
let _e1224 = local_5[1u];
let _e1227 = (_e1090 + (((_e1126 + ((bitcast<f32>(_e1135) - _e1126) * _e1137)) - _e1090) * _e1224));
let _e1228 = local_5[2u];
let _e1232 = local_5[1u];
let _e1236 = local_5[2u];
let _e1240 = local_5[2u];
let _e1247 = global_1.member.member_6.member_5;
let _e1252 = global_1.member.member_6.member_6;
let _e1253 = (((_e1170 + ((_e1174 - _e1170) * _e1240)) * _e1247) + _e1252);
let _e1255 = select(0f, _e1253, (_e1253 > 0f));
let _e1257 = select(1f, _e1255, (_e1255 < 1f));
let _e1259 = (((_e1178 + (((_e904 + (((_e923 + ((_e933 - _e923) * _e954)) - _e904) * _e1179)) - _e1178) * _e1184)) * _e1247) + _e1252);
let _e1261 = select(0f, _e1259, (_e1259 > 0f));
let _e1263 = select(1f, _e1261, (_e1261 < 1f));
let _e1265 = (((_e1191 + (((_e912 + (((_e943 + ((bitcast<f32>(_e952) - _e943) * _e962)) - _e912) * _e1192)) - _e1191) * _e1196)) * _e1247) + _e1252);
let _e1267 = select(0f, _e1265, (_e1265 > 0f));
let _e1269 = select(1f, _e1267, (_e1267 < 1f));
let _e1271 = (((_e1203 + (((_e1040 + ((_e908 - _e1040) * _e1204)) - _e1203) * _e1208)) * _e1247) + _e1252);
let _e1273 = select(0f, _e1271, (_e1271 > 0f));
let _e1275 = select(1f, _e1273, (_e1273 < 1f));
let _e1277 = (((_e1215 + (((_e961 + (((_e1051 + ((bitcast<f32>(_e1060) - _e1051) * _e1062)) - _e961) * _e1216)) - _e1215) * _e1220)) * _e1247) + _e1252);
let _e1279 = select(0f, _e1277, (_e1277 > 0f));
let _e1281 = select(1f, _e1279, (_e1279 < 1f));
let _e1283 = (((_e1227 + ((_e1170 - _e1227) * _e1228)) * _e1247) + _e1252);
let _e1285 = select(0f, _e1283, (_e1283 > 0f));
let _e1287 = select(1f, _e1285, (_e1285 < 1f));
let _e1289 = (((_e1174 + (((_e1115 + (((_e1151 + ((bitcast<f32>(_e1160) - _e1151) * _e1162)) - _e1115) * _e1232)) - _e1174) * _e1236)) * _e1247) + _e1252);
let _e1291 = select(0f, _e1289, (_e1289 > 0f));
let _e1293 = select(1f, _e1291, (_e1291 < 1f));
let _e1294 = (_e1257 * 1024f);
let _e1295 = (1024f - 1f);
let _e1297 = select(0f, _e1294, (_e1294 > 0f));
let _e1299 = select(_e1295, _e1297, (_e1297 < _e1295));
let _e1306 = select(0i, select(select(i32(_e1299), i32(-2147483648), (_e1299 < -2147483600f)), 2147483647i, (_e1299 > 2147483500f)), (_e1299 == _e1299));
let _e1310 = (_e1306 - select(0i, 1i, (_e1299 < f32(_e1306))));
let _e1311 = (262147i + _e1310);
let _e1313 = (bitcast<i32>(_e95) - 1i);
let _e1315 = select(_e1313, _e1311, (_e1311 < _e1313));
let _e1321 = global_4.member[bitcast<u32>(select(0i, _e1315, (_e1315 > 0i)))];
let _e1331 = select(_e1313, 262146i, (262146i < _e1313));
let _e1337 = global_4.member[bitcast<u32>(select(0i, _e1331, (_e1331 > 0i)))];
let _e1338 = bitcast<f32>(_e1337);
let _e1339 = (f32((bitcast<i32>((_e1321 & 4095u)) - 2048i)) * _e1338);
let _e1341 = select(_e1313, 262144i, (262144i < _e1313));
let _e1347 = global_4.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1348 = bitcast<f32>(_e1347);
let _e1350 = select(_e1313, 262145i, (262145i < _e1313));
let _e1356 = global_4.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1357 = bitcast<f32>(_e1356);
let _e1363 = ((_e1348 + (f32(bitcast<i32>((_e1321 >> bitcast<u32>(12u)))) * _e1357)) + (_e1339 * (_e1294 - f32(_e1310))));
let _e1364 = (_e1339 * 1024f);
if _e624 {
let _e1371 = ((0.5f * (_e1269 - _e1263)) * _e1364);
let _e1372 = ((0.5f * (_e1281 - _e1275)) * _e1364);
let _e1373 = ((0.5f * (_e1293 - _e1287)) * _e1364);
phi_3637_ = type_29(_e1363, vec3<f32>(_e1371, _e1372, _e1373), vec3<f32>((_e1371 * _e1363), (_e1372 * _e1363), (_e1373 * _e1363)));
} else {
let _e1380 = (_e1263 * 1024f);
let _e1382 = select(0f, _e1380, (_e1380 > 0f));
let _e1384 = select(_e1295, _e1382, (_e1382 < _e1295));
let _e1391 = select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384));
let _e1395 = (_e1391 - select(0i, 1i, (_e1384 < f32(_e1391))));
let _e1396 = (262147i + _e1395);
let _e1398 = select(_e1313, _e1396, (_e1396 < _e1313));
let _e1404 = global_4.member[bitcast<u32>(select(0i, _e1398, (_e1398 > 0i)))];
let _e1419 = ((_e1348 + (f32(bitcast<i32>((_e1404 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1404 & 4095u)) - 2048i)) * _e1338) * (_e1380 - f32(_e1395))));
let _e1420 = (_e1269 * 1024f);
let _e1422 = select(0f, _e1420, (_e1420 > 0f));
let _e1424 = select(_e1295, _e1422, (_e1422 < _e1295));
let _e1431 = select(0i, select(select(i32(_e1424), i32(-2147483648), (_e1424 < -2147483600f)), 2147483647i, (_e1424 > 2147483500f)), (_e1424 == _e1424));
let _e1435 = (_e1431 - select(0i, 1i, (_e1424 < f32(_e1431))));
let _e1436 = (262147i + _e1435);
let _e1438 = select(_e1313, _e1436, (_e1436 < _e1313));
let _e1444 = global_4.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1459 = ((_e1348 + (f32(bitcast<i32>((_e1444 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1444 & 4095u)) - 2048i)) * _e1338) * (_e1420 - f32(_e1435))));
let _e1460 = (_e1275 * 1024f);
let _e1462 = select(0f, _e1460, (_e1460 > 0f));
let _e1464 = select(_e1295, _e1462, (_e1462 < _e1295));
let _e1471 = select(0i, select(select(i32(_e1464), i32(-2147483648), (_e1464 < -2147483600f)), 2147483647i, (_e1464 > 2147483500f)), (_e1464 == _e1464));
let _e1475 = (_e1471 - select(0i, 1i, (_e1464 < f32(_e1471))));
let _e1476 = (262147i + _e1475);
let _e1478 = select(_e1313, _e1476, (_e1476 < _e1313));
let _e1484 = global_4.member[bitcast<u32>(select(0i, _e1478, (_e1478 > 0i)))];
let _e1499 = ((_e1348 + (f32(bitcast<i32>((_e1484 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1484 & 4095u)) - 2048i)) * _e1338) * (_e1460 - f32(_e1475))));
let _e1500 = (_e1281 * 1024f);
let _e1502 = select(0f, _e1500, (_e1500 > 0f));
let _e1504 = select(_e1295, _e1502, (_e1502 < _e1295));
let _e1511 = select(0i, select(select(i32(_e1504), i32(-2147483648), (_e1504 < -2147483600f)), 2147483647i, (_e1504 > 2147483500f)), (_e1504 == _e1504));
let _e1515 = (_e1511 - select(0i, 1i, (_e1504 < f32(_e1511))));
let _e1516 = (262147i + _e1515);
let _e1518 = select(_e1313, _e1516, (_e1516 < _e1313));
let _e1524 = global_4.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1539 = ((_e1348 + (f32(bitcast<i32>((_e1524 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1524 & 4095u)) - 2048i)) * _e1338) * (_e1500 - f32(_e1515))));
let _e1540 = (_e1287 * 1024f);
let _e1542 = select(0f, _e1540, (_e1540 > 0f));
let _e1544 = select(_e1295, _e1542, (_e1542 < _e1295));
let _e1551 = select(0i, select(select(i32(_e1544), i32(-2147483648), (_e1544 < -2147483600f)), 2147483647i, (_e1544 > 2147483500f)), (_e1544 == _e1544));
let _e1555 = (_e1551 - select(0i, 1i, (_e1544 < f32(_e1551))));
let _e1556 = (262147i + _e1555);
let _e1558 = select(_e1313, _e1556, (_e1556 < _e1313));
let _e1564 = global_4.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1579 = ((_e1348 + (f32(bitcast<i32>((_e1564 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1564 & 4095u)) - 2048i)) * _e1338) * (_e1540 - f32(_e1555))));
let _e1580 = (_e1293 * 1024f);
let _e1582 = select(0f, _e1580, (_e1580 > 0f));
let _e1584 = select(_e1295, _e1582, (_e1582 < _e1295));
let _e1591 = select(0i, select(select(i32(_e1584), i32(-2147483648), (_e1584 < -2147483600f)), 2147483647i, (_e1584 > 2147483500f)), (_e1584 == _e1584));
let _e1595 = (_e1591 - select(0i, 1i, (_e1584 < f32(_e1591))));
let _e1596 = (262147i + _e1595);
let _e1598 = select(_e1313, _e1596, (_e1596 < _e1313));
let _e1604 = global_4.member[bitcast<u32>(select(0i, _e1598, (_e1598 > 0i)))];
let _e1619 = ((_e1348 + (f32(bitcast<i32>((_e1604 >> bitcast<u32>(12u)))) * _e1357)) + ((f32((bitcast<i32>((_e1604 & 4095u)) - 2048i)) * _e1338) * (_e1580 - f32(_e1595))));
let _e1620 = (_e1459 - _e1419);
let _e1622 = (_e1539 - _e1499);
let _e1624 = (_e1619 - _e1579);
phi_3637_ = type_29(_e1363, vec3<f32>((0.5f * _e1620), (0.5f * _e1622), (0.5f * _e1624)), vec3<f32>((0.25f * (_e1620 * (_e1459 + _e1419))), (0.25f * (_e1622 * (_e1539 + _e1499))), (0.25f * (_e1624 * (_e1619 + _e1579)))));
}
let _e1639 = phi_3637_;
let _e1654 = select(0f, 1f, ((((((_e430 >= -0.5f) && (_e430 <= _e452)) && (_e436 >= -0.5f)) && (_e436 <= _e462)) && (_e442 >= -0.5f)) && (_e442 <= _e472)));
let _e1656 = (0.5f * (_e1269 - _e1263));
let _e1658 = (0.5f * (_e1281 - _e1275));
let _e1660 = (0.5f * (_e1293 - _e1287));
let _e1666 = global_1.member.member_6.member.member.member;
let _e1672 = global_1.member.member_6.member.member.member_1;
let _e1678 = global_1.member.member_6.member.member.member_2;
let _e1684 = global_1.member.member_6.member_1.member.member;
let _e1690 = global_1.member.member_6.member_1.member.member_1;
let _e1696 = global_1.member.member_6.member_1.member.member_2;
let _e1702 = global_1.member.member_6.member_2.member.member;
let _e1708 = global_1.member.member_6.member_2.member.member_1;
let _e1714 = global_1.member.member_6.member_2.member.member_2;
phi_4246_ = type_30(_e1257, vec3<f32>(((((_e1666 * _e1656) + (_e1684 * _e1658)) + (_e1702 * _e1660)) * _e1654), ((((_e1672 * _e1656) + (_e1690 * _e1658)) + (_e1708 * _e1660)) * _e1654), ((((_e1678 * _e1656) + (_e1696 * _e1658)) + (_e1714 * _e1660)) * _e1654)), _e1639.member, vec3<f32>(((((_e1666 * _e1639.member_2.x) + (_e1684 * _e1639.member_2.y)) + (_e1702 * _e1639.member_2.z)) * _e1654), ((((_e1672 * _e1639.member_2.x) + (_e1690 * _e1639.member_2.y)) + (_e1708 * _e1639.member_2.z)) * _e1654), ((((_e1678 * _e1639.member_2.x) + (_e1696 * _e1639.member_2.y)) + (_e1714 * _e1639.member_2.z)) * _e1654)), vec3<f32>(((((_e1666 * _e1639.member_1.x) + (_e1684 * _e1639.member_1.y)) + (_e1702 * _e1639.member_1.z)) * _e1654), ((((_e1672 * _e1639.member_1.x) + (_e1690 * _e1639.member_1.y)) + (_e1708 * _e1639.member_1.z)) * _e1654), ((((_e1678 * _e1639.member_1.x) + (_e1696 * _e1639.member_1.y)) + (_e1714 * _e1639.member_1.z)) * _e1654)));
} else {
let _e1780 = select(-1f, _e456, (_e456 > -1f));
let _e1782 = select(_e451, _e1780, (_e1780 < _e451));
let _e1789 = select(0i, select(select(i32(_e1782), i32(-2147483648), (_e1782 < -2147483600f)), 2147483647i, (_e1782 > 2147483500f)), (_e1782 == _e1782));
let _e1793 = (_e1789 - select(0i, 1i, (_e1782 < f32(_e1789))));
let _e1795 = select(-1f, _e466, (_e466 > -1f));
let _e1797 = select(_e461, _e1795, (_e1795 < _e461));
let _e1804 = select(0i, select(select(i32(_e1797), i32(-2147483648), (_e1797 < -2147483600f)), 2147483647i, (_e1797 > 2147483500f)), (_e1797 == _e1797));
let _e1808 = (_e1804 - select(0i, 1i, (_e1797 < f32(_e1804))));
let _e1810 = select(-1f, _e476, (_e476 > -1f));
let _e1812 = select(_e471, _e1810, (_e1810 < _e471));
let _e1819 = select(0i, select(select(i32(_e1812), i32(-2147483648), (_e1812 < -2147483600f)), 2147483647i, (_e1812 > 2147483500f)), (_e1812 == _e1812));
let _e1823 = (_e1819 - select(0i, 1i, (_e1812 < f32(_e1819))));
let _e1827 = global_1.member.member_6.member_7;
let _e1831 = global_1.member.member_6.member_8;
let _e1832 = (_e1793 + 1i);
let _e1833 = (_e1808 + 1i);
let _e1834 = (_e1823 + 1i);
let _e1839 = global_1.member.member_6.member_11.member;
let _e1845 = global_1.member.member_6.member_11.member_1;
let _e1856 = ((_e1832 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1839) * ((_e1833 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1845) * (_e1834 >> bitcast<u32>(4i))))));
let _e1858 = (bitcast<i32>(_e91) - 1i);
let _e1860 = select(_e1858, _e1856, (_e1856 < _e1858));
let _e1866 = global_2.member[bitcast<u32>(select(0i, _e1860, (_e1860 > 0i)))];
let _e1868 = (_e1832 & 15i);
let _e1871 = ((_e1833 & 15i) * _e1827);
let _e1873 = (bitcast<i32>(_e1866) + ((_e1834 & 15i) * _e1831));
let _e1877 = (_e1871 + _e1827);
let _e1879 = (_e1871 + (2i * _e1827));
let _e1880 = (_e1873 + _e1831);
let _e1882 = (_e1873 + (2i * _e1831));
local_2 = type_28(array<i32, 4>(_e1868, (_e1868 + 1i), (_e1868 + 2i), (_e1868 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e456 - f32(_e1793)), (_e466 - f32(_e1808)), (_e476 - f32(_e1823)));
let _e1893 = (_e1880 + _e1877);
let _e1896 = local_2.member[1u];
let _e1897 = (_e1893 + _e1896);
let _e1899 = select(_e1858, _e1897, (_e1897 < _e1858));
let _e1904 = global_2.member[bitcast<u32>(select(0i, _e1899, (_e1899 > 0i)))];
let _e1905 = bitcast<f32>(_e1904);
let _e1908 = local_2.member[2u];
let _e1909 = (_e1893 + _e1908);
let _e1911 = select(_e1858, _e1909, (_e1909 < _e1858));
let _e1916 = global_2.member[bitcast<u32>(select(0i, _e1911, (_e1911 > 0i)))];
let _e1918 = local_3[0u];
let _e1921 = (_e1905 + ((bitcast<f32>(_e1916) - _e1905) * _e1918));
let _e1922 = (_e1880 + _e1879);
let _e1923 = local_2.member[1u];
let _e1924 = (_e1922 + _e1923);
let _e1926 = select(_e1858, _e1924, (_e1924 < _e1858));
let _e1931 = global_2.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1932 = bitcast<f32>(_e1931);
let _e1933 = local_2.member[2u];
let _e1934 = (_e1922 + _e1933);
let _e1936 = select(_e1858, _e1934, (_e1934 < _e1858));
let _e1941 = global_2.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1943 = local_3[0u];
let _e1948 = local_3[1u];
let _e1951 = (_e1921 + (((_e1932 + ((bitcast<f32>(_e1941) - _e1932) * _e1943)) - _e1921) * _e1948));
let _e1952 = (_e1882 + _e1877);
let _e1953 = local_2.member[1u];
let _e1954 = (_e1952 + _e1953);
let _e1956 = select(_e1858, _e1954, (_e1954 < _e1858));
let _e1961 = global_2.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1962 = bitcast<f32>(_e1961);
let _e1963 = local_2.member[2u];
let _e1964 = (_e1952 + _e1963);
let _e1966 = select(_e1858, _e1964, (_e1964 < _e1858));
let _e1971 = global_2.member[bitcast<u32>(select(0i, _e1966, (_e1966 > 0i)))];
let _e1973 = local_3[0u];
let _e1976 = (_e1962 + ((bitcast<f32>(_e1971) - _e1962) * _e1973));
let _e1977 = (_e1882 + _e1879);
let _e1978 = local_2.member[1u];
let _e1979 = (_e1977 + _e1978);
let _e1981 = select(_e1858, _e1979, (_e1979 < _e1858));
let _e1986 = global_2.member[bitcast<u32>(select(0i, _e1981, (_e1981 > 0i)))];
let _e1987 = bitcast<f32>(_e1986);
let _e1988 = local_2.member[2u];
let _e1989 = (_e1977 + _e1988);
let _e1991 = select(_e1858, _e1989, (_e1989 < _e1858));
let _e1996 = global_2.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e1998 = local_3[0u];
let _e2002 = local_3[1u];
let _e2007 = local_3[2u];
let _e2014 = global_1.member.member_6.member_5;
let _e2019 = global_1.member.member_6.member_6;
let _e2020 = (((_e1951 + (((_e1976 + (((_e1987 + ((bitcast<f32>(_e1996) - _e1987) * _e1998)) - _e1976) * _e2002)) - _e1951) * _e2007)) * _e2014) + _e2019);
let _e2022 = select(0f, _e2020, (_e2020 > 0f));
phi_4246_ = type_30(select(1f, _e2022, (_e2022 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2027 = phi_4246_;
let _e2029 = select(-0.5f, _e394, (_e394 > -0.5f));
let _e2031 = select(_e452, _e2029, (_e2029 < _e452));
let _e2033 = select(-0.5f, _e409, (_e409 > -0.5f));
let _e2035 = select(_e462, _e2033, (_e2033 < _e462));
let _e2037 = select(-0.5f, _e424, (_e424 > -0.5f));
let _e2039 = select(_e472, _e2037, (_e2037 < _e472));
let _e2041 = select(-1f, _e2031, (_e2031 > -1f));
let _e2043 = select(_e451, _e2041, (_e2041 < _e451));
let _e2050 = select(0i, select(select(i32(_e2043), i32(-2147483648), (_e2043 < -2147483600f)), 2147483647i, (_e2043 > 2147483500f)), (_e2043 == _e2043));
let _e2054 = (_e2050 - select(0i, 1i, (_e2043 < f32(_e2050))));
let _e2056 = select(-1f, _e2035, (_e2035 > -1f));
let _e2058 = select(_e461, _e2056, (_e2056 < _e461));
let _e2065 = select(0i, select(select(i32(_e2058), i32(-2147483648), (_e2058 < -2147483600f)), 2147483647i, (_e2058 > 2147483500f)), (_e2058 == _e2058));
let _e2069 = (_e2065 - select(0i, 1i, (_e2058 < f32(_e2065))));
let _e2071 = select(-1f, _e2039, (_e2039 > -1f));
let _e2073 = select(_e471, _e2071, (_e2071 < _e471));
let _e2080 = select(0i, select(select(i32(_e2073), i32(-2147483648), (_e2073 < -2147483600f)), 2147483647i, (_e2073 > 2147483500f)), (_e2073 == _e2073));
let _e2084 = (_e2080 - select(0i, 1i, (_e2073 < f32(_e2080))));
let _e2088 = global_1.member.member_6.member_7;
let _e2092 = global_1.member.member_6.member_8;
let _e2093 = (_e2054 + 1i);
let _e2094 = (_e2069 + 1i);
let _e2095 = (_e2084 + 1i);
let _e2100 = global_1.member.member_6.member_11.member;
let _e2106 = global_1.member.member_6.member_11.member_1;
let _e2117 = ((_e2093 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2100) * ((_e2094 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2106) * (_e2095 >> bitcast<u32>(4i))))));
let _e2119 = (bitcast<i32>(_e91) - 1i);
let _e2121 = select(_e2119, _e2117, (_e2117 < _e2119));
let _e2127 = global_2.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2129 = (_e2093 & 15i);
let _e2132 = ((_e2094 & 15i) * _e2088);
let _e2134 = (bitcast<i32>(_e2127) + ((_e2095 & 15i) * _e2092));
let _e2138 = (_e2132 + _e2088);
let _e2140 = (_e2132 + (2i * _e2088));
let _e2141 = (_e2134 + _e2092);
let _e2143 = (_e2134 + (2i * _e2092));
local = type_28(array<i32, 4>(_e2129, (_e2129 + 1i), (_e2129 + 2i), (_e2129 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2031 - f32(_e2054)), (_e2035 - f32(_e2069)), (_e2039 - f32(_e2084)));
let _e2154 = (_e2141 + _e2138);
let _e2157 = local.member[1u];
let _e2158 = (_e2154 + _e2157);
let _e2160 = select(_e2119, _e2158, (_e2158 < _e2119));
let _e2165 = global_2.member[bitcast<u32>(select(0i, _e2160, (_e2160 > 0i)))];
let _e2166 = bitcast<f32>(_e2165);
let _e2169 = local.member[2u];
let _e2170 = (_e2154 + _e2169);
let _e2172 = select(_e2119, _e2170, (_e2170 < _e2119));
let _e2177 = global_2.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2179 = local_1[0u];
let _e2182 = (_e2166 + ((bitcast<f32>(_e2177) - _e2166) * _e2179));
let _e2183 = (_e2141 + _e2140);
let _e2184 = local.member[1u];
let _e2185 = (_e2183 + _e2184);
let _e2187 = select(_e2119, _e2185, (_e2185 < _e2119));
let _e2192 = global_2.member[bitcast<u32>(select(0i, _e2187, (_e2187 > 0i)))];
let _e2193 = bitcast<f32>(_e2192);
let _e2194 = local.member[2u];
let _e2195 = (_e2183 + _e2194);
let _e2197 = select(_e2119, _e2195, (_e2195 < _e2119));
let _e2202 = global_2.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2204 = local_1[0u];
let _e2209 = local_1[1u];
let _e2212 = (_e2182 + (((_e2193 + ((bitcast<f32>(_e2202) - _e2193) * _e2204)) - _e2182) * _e2209));
let _e2213 = (_e2143 + _e2138);
let _e2214 = local.member[1u];
let _e2215 = (_e2213 + _e2214);
let _e2217 = select(_e2119, _e2215, (_e2215 < _e2119));
let _e2222 = global_2.member[bitcast<u32>(select(0i, _e2217, (_e2217 > 0i)))];
let _e2223 = bitcast<f32>(_e2222);
let _e2224 = local.member[2u];
let _e2225 = (_e2213 + _e2224);
let _e2227 = select(_e2119, _e2225, (_e2225 < _e2119));
let _e2232 = global_2.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2234 = local_1[0u];
let _e2237 = (_e2223 + ((bitcast<f32>(_e2232) - _e2223) * _e2234));
let _e2238 = (_e2143 + _e2140);
let _e2239 = local.member[1u];
let _e2240 = (_e2238 + _e2239);
let _e2242 = select(_e2119, _e2240, (_e2240 < _e2119));
let _e2247 = global_2.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2248 = bitcast<f32>(_e2247);
let _e2249 = local.member[2u];
let _e2250 = (_e2238 + _e2249);
let _e2252 = select(_e2119, _e2250, (_e2250 < _e2119));
let _e2257 = global_2.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2259 = local_1[0u];
let _e2263 = local_1[1u];
let _e2268 = local_1[2u];
let _e2275 = global_1.member.member_6.member_5;
let _e2280 = global_1.member.member_6.member_6;
let _e2281 = (((_e2212 + (((_e2237 + (((_e2248 + ((bitcast<f32>(_e2257) - _e2248) * _e2259)) - _e2237) * _e2263)) - _e2212) * _e2268)) * _e2275) + _e2280);
let _e2283 = select(0f, _e2281, (_e2281 > 0f));
if ((_e610 & 16u) == 0u) {
phi_5078_ = type_5(1f, 1f, 1f);
} else {
let _e2291 = global_1.member.member_14.member;
let _e2302 = ((((_e2291.member.member * _e305) + (_e2291.member.member_1 * _e314)) + (_e2291.member.member_2 * _e287)) + _e2291.member_1);
let _e2308 = ((((_e2291.member.member * _e326) + (_e2291.member.member_1 * _e331)) + (_e2291.member.member_2 * _e320)) + _e2291.member_1);
let _e2310 = select(_e2308, _e2302, (_e2302 < _e2308));
let _e2312 = select(_e2308, _e2302, (_e2302 > _e2308));
let _e2314 = (_e2312 - _e2310);
let _e2317 = (-(_e2310) / select(1e-30f, _e2314, (_e2314 > 1e-30f)));
let _e2319 = select(0f, _e2317, (_e2317 > 0f));
let _e2325 = select(select(select(1f, _e2319, (_e2319 < 1f)), 1f, (_e2312 <= 0f)), 0f, (_e2310 > 0f));
let _e2330 = global_1.member.member_14.member_1;
let _e2331 = (_e2330 != 0u);
let _e2341 = global_1.member.member_15.member;
let _e2352 = ((((_e2341.member.member * _e305) + (_e2341.member.member_1 * _e314)) + (_e2341.member.member_2 * _e287)) + _e2341.member_1);
let _e2358 = ((((_e2341.member.member * _e326) + (_e2341.member.member_1 * _e331)) + (_e2341.member.member_2 * _e320)) + _e2341.member_1);
let _e2360 = select(_e2358, _e2352, (_e2352 < _e2358));
let _e2362 = select(_e2358, _e2352, (_e2352 > _e2358));
let _e2364 = (_e2362 - _e2360);
let _e2367 = (-(_e2360) / select(1e-30f, _e2364, (_e2364 > 1e-30f)));
let _e2369 = select(0f, _e2367, (_e2367 > 0f));
let _e2375 = select(select(select(1f, _e2369, (_e2369 < 1f)), 1f, (_e2362 <= 0f)), 0f, (_e2360 > 0f));
let _e2380 = global_1.member.member_15.member_1;
let _e2381 = (_e2380 != 0u);
let _e2391 = global_1.member.member_16.member;
let _e2402 = ((((_e2391.member.member * _e305) + (_e2391.member.member_1 * _e314)) + (_e2391.member.member_2 * _e287)) + _e2391.member_1);
let _e2408 = ((((_e2391.member.member * _e326) + (_e2391.member.member_1 * _e331)) + (_e2391.member.member_2 * _e320)) + _e2391.member_1);
let _e2410 = select(_e2408, _e2402, (_e2402 < _e2408));
let _e2412 = select(_e2408, _e2402, (_e2402 > _e2408));
let _e2414 = (_e2412 - _e2410);
let _e2417 = (-(_e2410) / select(1e-30f, _e2414, (_e2414 > 1e-30f)));
let _e2419 = select(0f, _e2417, (_e2417 > 0f));
let _e2425 = select(select(select(1f, _e2419, (_e2419 < 1f)), 1f, (_e2412 <= 0f)), 0f, (_e2410 > 0f));
let _e2430 = global_1.member.member_16.member_1;
let _e2431 = (_e2430 != 0u);
let _e2441 = global_1.member.member_17.member;
let _e2452 = ((((_e2441.member.member * _e305) + (_e2441.member.member_1 * _e314)) + (_e2441.member.member_2 * _e287)) + _e2441.member_1);
let _e2458 = ((((_e2441.member.member * _e326) + (_e2441.member.member_1 * _e331)) + (_e2441.member.member_2 * _e320)) + _e2441.member_1);
let _e2460 = select(_e2458, _e2452, (_e2452 < _e2458));
let _e2462 = select(_e2458, _e2452, (_e2452 > _e2458));
let _e2464 = (_e2462 - _e2460);
let _e2467 = (-(_e2460) / select(1e-30f, _e2464, (_e2464 > 1e-30f)));
let _e2469 = select(0f, _e2467, (_e2467 > 0f));
let _e2475 = select(select(select(1f, _e2469, (_e2469 < 1f)), 1f, (_e2462 <= 0f)), 0f, (_e2460 > 0f));
let _e2480 = global_1.member.member_17.member_1;
let _e2481 = (_e2480 != 0u);
phi_5078_ = type_5(((((1f * _e2325) * _e2375) * _e2425) * _e2475), ((((1f * select(1f, _e2325, _e2331)) * select(1f, _e2375, _e2381)) * select(1f, _e2425, _e2431)) * select(1f, _e2475, _e2481)), ((((1f * select(1f, 0f, (_e2331 && (_e2308 > 0f)))) * select(1f, 0f, (_e2381 && (_e2358 > 0f)))) * select(1f, 0f, (_e2431 && (_e2408 > 0f)))) * select(1f, 0f, (_e2481 && (_e2458 > 0f)))));
}
let _e2490 = phi_5078_;
let _e2491 = (_e326 - _e305);
let _e2492 = (_e331 - _e314);
let _e2493 = (_e320 - _e287);
let _e2498 = (((_e2491 * _e2491) + (_e2492 * _e2492)) + (_e2493 * _e2493));
let _e2502 = (_e482 < 1e-12f);
let _e2504 = (1f / select(_e477, 1f, _e2502));
let _e2506 = ((-0.5f - _e394) * _e2504);
let _e2508 = ((_e452 - _e394) * _e2504);
let _e2514 = select(_e2508, _e2506, (_e2506 < _e2508));
let _e2516 = select(0f, _e2514, (_e2514 > 0f));
let _e2519 = select(select(1f, _e2516, (_e2516 < 1f)), select(2f, 0f, ((_e394 >= -0.5f) && (_e394 <= _e452))), _e2502);
let _e2521 = select(_e2508, _e2506, (_e2506 > _e2508));
let _e2523 = select(0f, _e2521, (_e2521 > 0f));
let _e2526 = select(select(1f, _e2523, (_e2523 < 1f)), 1f, _e2502);
let _e2527 = (_e485 < 1e-12f);
let _e2529 = (1f / select(_e478, 1f, _e2527));
let _e2531 = ((-0.5f - _e409) * _e2529);
let _e2533 = ((_e462 - _e409) * _e2529);
let _e2539 = select(_e2533, _e2531, (_e2531 < _e2533));
let _e2541 = select(0f, _e2539, (_e2539 > 0f));
let _e2544 = select(select(1f, _e2541, (_e2541 < 1f)), select(2f, 0f, ((_e409 >= -0.5f) && (_e409 <= _e462))), _e2527);
let _e2546 = select(_e2533, _e2531, (_e2531 > _e2533));
let _e2548 = select(0f, _e2546, (_e2546 > 0f));
let _e2551 = select(select(1f, _e2548, (_e2548 < 1f)), 1f, _e2527);
let _e2552 = (_e490 < 1e-12f);
let _e2554 = (1f / select(_e479, 1f, _e2552));
let _e2556 = ((-0.5f - _e424) * _e2554);
let _e2558 = ((_e472 - _e424) * _e2554);
let _e2564 = select(_e2558, _e2556, (_e2556 < _e2558));
let _e2566 = select(0f, _e2564, (_e2564 > 0f));
let _e2569 = select(select(1f, _e2566, (_e2566 < 1f)), select(2f, 0f, ((_e424 >= -0.5f) && (_e424 <= _e472))), _e2552);
let _e2571 = select(_e2558, _e2556, (_e2556 > _e2558));
let _e2573 = select(0f, _e2571, (_e2571 > 0f));
let _e2576 = select(select(1f, _e2573, (_e2573 < 1f)), 1f, _e2552);
let _e2578 = select(_e2551, _e2526, (_e2526 < _e2551));
let _e2582 = select(_e2544, _e2519, (_e2519 > _e2544));
let _e2585 = (select(_e2576, _e2578, (_e2578 < _e2576)) - select(_e2569, _e2582, (_e2582 > _e2569)));
let _e2592 = global_1.member.member_5.member_3;
let _e2593 = ((sqrt(select(0f, _e2498, (_e2498 > 0f))) * select(0f, _e2585, (_e2585 > 0f))) * _e2592);
let _e2595 = (select(1f, _e2283, (_e2283 < 1f)) * 255f);
let _e2596 = (_e2027.member * 255f);
let _e2597 = (255f - 1f);
let _e2599 = select(0f, _e2595, (_e2595 > 0f));
let _e2601 = select(_e2597, _e2599, (_e2599 < _e2597));
let _e2608 = select(0i, select(select(i32(_e2601), i32(-2147483648), (_e2601 < -2147483600f)), 2147483647i, (_e2601 > 2147483500f)), (_e2601 == _e2601));
let _e2612 = (_e2608 - select(0i, 1i, (_e2601 < f32(_e2608))));
let _e2614 = select(0f, _e2596, (_e2596 > 0f));
let _e2616 = select(_e2597, _e2614, (_e2614 < _e2597));
let _e2623 = select(0i, select(select(i32(_e2616), i32(-2147483648), (_e2616 < -2147483600f)), 2147483647i, (_e2616 > 2147483500f)), (_e2616 == _e2616));
let _e2627 = (_e2623 - select(0i, 1i, (_e2616 < f32(_e2623))));
let _e2630 = (((_e2612 * 256i) + _e2627) * 4i);
let _e2632 = (_e2595 - f32(_e2612));
let _e2634 = (_e2596 - f32(_e2627));
let _e2636 = (bitcast<i32>(_e95) - 1i);
let _e2638 = select(_e2636, _e2630, (_e2630 < _e2636));
let _e2644 = global_4.member[bitcast<u32>(select(0i, _e2638, (_e2638 > 0i)))];
let _e2645 = (_e2630 + 4i);
let _e2647 = select(_e2636, _e2645, (_e2645 < _e2636));
let _e2653 = global_4.member[bitcast<u32>(select(0i, _e2647, (_e2647 > 0i)))];
let _e2654 = (_e2630 + 1024i);
let _e2656 = select(_e2636, _e2654, (_e2654 < _e2636));
let _e2662 = global_4.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2663 = (_e2630 + 1028i);
let _e2665 = select(_e2636, _e2663, (_e2663 < _e2636));
let _e2671 = global_4.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2676 = (bitcast<f32>(((_e2644 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2684 = (_e2676 + (((bitcast<f32>(((_e2653 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2676) * _e2634));
let _e2689 = (bitcast<f32>(((_e2662 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2713 = (bitcast<f32>((((_e2644 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2721 = (_e2713 + (((bitcast<f32>((((_e2653 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2713) * _e2634));
let _e2726 = (bitcast<f32>((((_e2662 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2738 = (_e2630 + 1i);
let _e2740 = select(_e2636, _e2738, (_e2738 < _e2636));
let _e2746 = global_4.member[bitcast<u32>(select(0i, _e2740, (_e2740 > 0i)))];
let _e2747 = (_e2630 + 5i);
let _e2749 = select(_e2636, _e2747, (_e2747 < _e2636));
let _e2755 = global_4.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2756 = (_e2630 + 1025i);
let _e2758 = select(_e2636, _e2756, (_e2756 < _e2636));
let _e2764 = global_4.member[bitcast<u32>(select(0i, _e2758, (_e2758 > 0i)))];
let _e2765 = (_e2630 + 1029i);
let _e2767 = select(_e2636, _e2765, (_e2765 < _e2636));
let _e2773 = global_4.member[bitcast<u32>(select(0i, _e2767, (_e2767 > 0i)))];
let _e2778 = (bitcast<f32>(((_e2746 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2786 = (_e2778 + (((bitcast<f32>(((_e2755 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2778) * _e2634));
let _e2791 = (bitcast<f32>(((_e2764 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2815 = (bitcast<f32>((((_e2746 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2823 = (_e2815 + (((bitcast<f32>((((_e2755 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2815) * _e2634));
let _e2828 = (bitcast<f32>((((_e2764 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2843 = (_e2593 * _e2490.member_1);
let _e2845 = -(((_e2721 + (((_e2726 + (((bitcast<f32>((((_e2671 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2726) * _e2634)) - _e2721) * _e2632)) * _e2843));
let _e2847 = select(-87f, _e2845, (_e2845 > -87f));
let _e2849 = select(88f, _e2847, (_e2847 < 88f));
let _e2851 = ((_e2849 * 1.442695f) + 0.5f);
let _e2853 = select(-127f, _e2851, (_e2851 > -127f));
let _e2855 = select(128f, _e2853, (_e2853 < 128f));
let _e2862 = select(0i, select(select(i32(_e2855), i32(-2147483648), (_e2855 < -2147483600f)), 2147483647i, (_e2855 > 2147483500f)), (_e2855 == _e2855));
let _e2866 = (_e2862 - select(0i, 1i, (_e2855 < f32(_e2862))));
let _e2867 = f32(_e2866);
let _e2871 = ((_e2849 - (_e2867 * 0.6933594f)) - (_e2867 * -2.1219444e-4f));
let _e2893 = -(((_e2786 + (((_e2791 + (((bitcast<f32>(((_e2773 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2791) * _e2634)) - _e2786) * _e2632)) * _e2843));
let _e2895 = select(-87f, _e2893, (_e2893 > -87f));
let _e2897 = select(88f, _e2895, (_e2895 < 88f));
let _e2899 = ((_e2897 * 1.442695f) + 0.5f);
let _e2901 = select(-127f, _e2899, (_e2899 > -127f));
let _e2903 = select(128f, _e2901, (_e2901 < 128f));
let _e2910 = select(0i, select(select(i32(_e2903), i32(-2147483648), (_e2903 < -2147483600f)), 2147483647i, (_e2903 > 2147483500f)), (_e2903 == _e2903));
let _e2914 = (_e2910 - select(0i, 1i, (_e2903 < f32(_e2910))));
let _e2915 = f32(_e2914);
let _e2919 = ((_e2897 - (_e2915 * 0.6933594f)) - (_e2915 * -2.1219444e-4f));
let _e2941 = -(((_e2823 + (((_e2828 + (((bitcast<f32>((((_e2773 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2828) * _e2634)) - _e2823) * _e2632)) * _e2843));
let _e2943 = select(-87f, _e2941, (_e2941 > -87f));
let _e2945 = select(88f, _e2943, (_e2943 < 88f));
let _e2947 = ((_e2945 * 1.442695f) + 0.5f);
let _e2949 = select(-127f, _e2947, (_e2947 > -127f));
let _e2951 = select(128f, _e2949, (_e2949 < 128f));
let _e2958 = select(0i, select(select(i32(_e2951), i32(-2147483648), (_e2951 < -2147483600f)), 2147483647i, (_e2951 > 2147483500f)), (_e2951 == _e2951));
let _e2962 = (_e2958 - select(0i, 1i, (_e2951 < f32(_e2958))));
let _e2963 = f32(_e2962);
let _e2967 = ((_e2945 - (_e2963 * 0.6933594f)) - (_e2963 * -2.1219444e-4f));
let _e2989 = -(((_e2684 + (((_e2689 + (((bitcast<f32>(((_e2671 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2689) * _e2634)) - _e2684) * _e2632)) * (_e2593 * _e2490.member)));
let _e2991 = select(-87f, _e2989, (_e2989 > -87f));
let _e2993 = select(88f, _e2991, (_e2991 < 88f));
let _e2995 = ((_e2993 * 1.442695f) + 0.5f);
let _e2997 = select(-127f, _e2995, (_e2995 > -127f));
let _e2999 = select(128f, _e2997, (_e2997 < 128f));
let _e3006 = select(0i, select(select(i32(_e2999), i32(-2147483648), (_e2999 < -2147483600f)), 2147483647i, (_e2999 > 2147483500f)), (_e2999 == _e2999));
let _e3010 = (_e3006 - select(0i, 1i, (_e2999 < f32(_e3006))));
let _e3011 = f32(_e3010);
let _e3015 = ((_e2993 - (_e3011 * 0.6933594f)) - (_e3011 * -2.1219444e-4f));
let _e3035 = ((1f + (_e3015 * (1f + (_e3015 * (0.5f + (_e3015 * (0.16666667f + (_e3015 * (0.041666668f + (_e3015 * (0.008333334f + (_e3015 * (0.001388889f + (_e3015 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3010 + 127i)) << bitcast<u32>(23i))));
if _e627 {
let _e3050 = global_1.member.member_5.member_4;
let _e3053 = (_e2027.member_3.x * _e2490.member_2);
let _e3055 = (_e2027.member_3.y * _e2490.member_2);
let _e3057 = (_e2027.member_3.z * _e2490.member_2);
let _e3058 = (0.5f * (_e244 / _e196));
let _e3062 = (_e174 + (_e3053 * _e3058));
let _e3063 = (_e185 + (_e3055 * _e3058));
let _e3064 = (_e196 + (_e3057 * _e3058));
let _e3066 = (2f * _e244);
let _e3068 = ((_e3064 * _e3064) + (_e3066 * _e3057));
let _e3072 = (_e3064 + sqrt(select(0f, _e3068, (_e3068 > 0f))));
let _e3076 = (0.5f * (_e3066 / select(1e-6f, _e3072, (_e3072 > 1e-6f))));
let _e3080 = (_e3062 + (_e3053 * _e3076));
let _e3081 = (_e3063 + (_e3055 * _e3076));
let _e3082 = (_e3064 + (_e3057 * _e3076));
let _e3086 = (_e3050 * _e3050);
let _e3088 = (_e3082 * _e3082);
let _e3096 = (((_e3064 <= 0f) || (_e3068 <= 0f)) || ((_e3082 <= 0f) || (_e3088 <= (_e3086 * (((_e3080 * _e3080) + (_e3081 * _e3081)) + _e3088)))));
let _e3110 = (_e174 + ((_e2027.member_4.x * _e2490.member_2) * _e244));
let _e3111 = (_e185 + ((_e2027.member_4.y * _e2490.member_2) * _e244));
let _e3112 = (_e196 + ((_e2027.member_4.z * _e2490.member_2) * _e244));
let _e3114 = (_e3112 * _e3112);
let _e3123 = ((_e610 & 1u) != 0u);
phi_6102_ = select(select(select(_e3082, _e3064, _e3096), _e3112, _e3123), _e196, _e617);
phi_6103_ = select(select(select(_e3081, _e3063, _e3096), _e3111, _e3123), _e185, _e617);
phi_6104_ = select(select(select(_e3080, _e3062, _e3096), _e3110, _e3123), _e174, _e617);
phi_6105_ = (select(_e3096, ((_e3112 <= 0f) || (_e3114 <= (_e3086 * (((_e3110 * _e3110) + (_e3111 * _e3111)) + _e3114)))), _e3123) && !(_e617));
} else {
phi_6102_ = _e196;
phi_6103_ = _e185;
phi_6104_ = _e174;
phi_6105_ = false;
}
let _e3134 = phi_6102_;
let _e3136 = phi_6103_;
let _e3138 = phi_6104_;
let _e3140 = phi_6105_;
global_6.member[_e120] = (_e131 + _e259);
global_6.member[_e132] = (_e141 + _e266);
global_6.member[_e143] = (_e152 + _e368);
global_6.member[_e154] = (_e163 + _e371);
global_6.member[_e165] = _e3138;
global_6.member[_e176] = _e3136;
global_6.member[_e187] = _e3134;
global_6.member[_e198] = select((_e207 * (((1f + (_e2871 * (1f + (_e2871 * (0.5f + (_e2871 * (0.16666667f + (_e2871 * (0.041666668f + (_e2871 * (0.008333334f + (_e2871 * (0.001388889f + (_e2871 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2866 + 127i)) << bitcast<u32>(23i)))) * _e3035)), _e207, _e617);
global_6.member[_e209] = select((_e218 * (((1f + (_e2919 * (1f + (_e2919 * (0.5f + (_e2919 * (0.16666667f + (_e2919 * (0.041666668f + (_e2919 * (0.008333334f + (_e2919 * (0.001388889f + (_e2919 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2914 + 127i)) << bitcast<u32>(23i)))) * _e3035)), _e218, _e617);
global_6.member[_e220] = select((_e229 * (((1f + (_e2967 * (1f + (_e2967 * (0.5f + (_e2967 * (0.16666667f + (_e2967 * (0.041666668f + (_e2967 * (0.008333334f + (_e2967 * (0.001388889f + (_e2967 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2962 + 127i)) << bitcast<u32>(23i)))) * _e3035)), _e229, _e617);
global_6.member[_e231] = select(_e240, 1f, _e3140);
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
